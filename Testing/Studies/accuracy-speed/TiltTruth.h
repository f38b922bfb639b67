// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MethodTimer.h"

#include <ostream>
#include <string>

namespace palpate::testing
{
/// Writes rows for tilted tools on a half-space, compared with boundary elements of 128 pixels and
/// with the other code's `folder`/Reference/tilt/tilt_bem.csv; with a timer also times. `quick`
/// leaves out the tool that takes seconds to solve, and uses few depths and tilts.
void studyTilt(std::ostream& stream, const std::string& folder, bool quick, MethodTimer* timer);
} // namespace palpate::testing
