// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MethodTimer.h"

#include <ostream>
#include <string>

namespace palpate::testing
{
/// Writes rows for the methods of a relaxing body, as CSV. `part` is `force` (largest error on a
/// path, relative to its largest force), `time` (of a tick on the stop-and-go path of a sphere;
/// absent without `timer`) or `curve` (forces over time). `folder`: Data. Throws an exception with
/// the fault of a table.
void studyRelaxation(std::ostream& stream, const std::string& folder, MethodTimer* timer);
} // namespace palpate::testing
