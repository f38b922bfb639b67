// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ProfileFile_h
#define palpate_ProfileFile_h

#include "Mechanics/Tools/ProfileTool.h"

#include <string>
#include <vector>

namespace palpate
{
/**
 * Reads a tool's profile from text: a line r_mm,f_mm per point, the distance from the axis and the
 * height above the tip, from the tip (0,0) outward; the first line may be a header (CsvReader).
 * Returns what is wrong, naming the file and the line, and leaves the points unchanged then; empty
 * if nothing is.
 */
std::string readProfile(const std::string& file, std::vector<ProfilePoint>& points);
} // namespace palpate

#endif
