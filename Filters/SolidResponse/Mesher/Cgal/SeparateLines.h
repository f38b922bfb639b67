// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SeparateLines_h
#define palpate_SeparateLines_h

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// Points of a line in order, mm. The line is closed if the last point equals the first.
using Line = std::vector<Eigen::Vector3d>;

/**
 * Returns the parts of lines that cells with edges of a given length can follow. These parts are
 * removed: segments shorter than a quarter of the length; segments whose distance from another line
 * is less than the length; segments whose distance from another part of the same line is less than
 * the length, if the path along the line is more than twice the distance; and remaining parts
 * shorter than three times the length. A mesher that must separate lines would need an unlimited
 * number of cells at the removed parts. Lines may meet at their ends.
 */
std::vector<Line> separateLines(const std::vector<Line>& lines, double length);
} // namespace palpate

#endif
