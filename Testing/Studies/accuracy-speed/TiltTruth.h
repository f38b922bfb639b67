// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MethodTimer.h"

#include <ostream>
#include <string>

namespace palpate::testing
{
/// Rows of tools that lean on a half-space, against boundary elements of 128 pixels and, of another
/// code, `folder`/Reference/tilt/tilt_bem.csv; with a timer, times too. Quick: without the tool
/// that takes seconds to solve for, few depths and tilts.
void studyTilt(std::ostream& stream, const std::string& folder, bool quick, MethodTimer* timer);
} // namespace palpate::testing
