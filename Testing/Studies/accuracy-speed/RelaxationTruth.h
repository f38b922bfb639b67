// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MethodTimer.h"

#include <ostream>
#include <string>

namespace palpate::testing
{
/// Rows of the methods that render a body which relaxes, as CSV: `part` is `force` (largest error
/// on a path, of its largest force), `time` (of a tick along stop and go of a sphere; without
/// `timer` none) or `curve` (forces over time). `folder`: Data. Throws what is wrong with its
/// tables.
void studyRelaxation(std::ostream& stream, const std::string& folder, MethodTimer* timer);
} // namespace palpate::testing
