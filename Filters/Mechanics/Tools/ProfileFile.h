// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ProfileFile_h
#define palpate_ProfileFile_h

#include "Mechanics/Tools/ProfileTool.h"

#include <string>
#include <vector>

namespace palpate
{
/**
 * Reads a tool's profile from text. Each line is one point, r_mm,f_mm: the distance from the axis
 * and the height above the tip. The points go from the tip (0,0) outward. The first line may be a
 * header (CsvReader). Returns "", or a fault that names the file and the line; the points are then
 * unchanged.
 */
std::string readProfile(const std::string& file, std::vector<ProfilePoint>& points);
} // namespace palpate

#endif
