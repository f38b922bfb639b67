// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SeparateLines_h
#define palpate_SeparateLines_h

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// Points in their order, mm; closed if the last is the first.
using Line = std::vector<Eigen::Vector3d>;

/**
 * Of lines what cells of a given length can follow: without sides shorter than a quarter of it,
 * without what comes within it to another line, or to itself by a detour of twice that, and without
 * what is left in parts shorter than three times it. Along the rest a mesher that separates lines
 * would need cells without end. Lines may meet at their ends.
 */
std::vector<Line> separateLines(const std::vector<Line>& lines, double length);
} // namespace palpate

#endif
