// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrajectoryFile_h
#define palpate_TrajectoryFile_h

#include "ServoStep.h"

#include <string>
#include <vector>

namespace palpate
{
/// The columns of a trajectory file, in order.
extern const char* const TrajectoryColumns;

/**
 * Writes one line per tick as CSV: time, tip, contact point, deflection, normal force, friction,
 * ideal force (magnitude of the total, before any limit of the device), contact state. Body frame;
 * s, mm, N. Numbers are the shortest decimals that read back to the same bits; a column without a
 * value (no contact) is 0. Returns an error naming the file, or "".
 */
std::string writeTrajectory(const std::string& path, const std::vector<ServoTick>& ticks);
} // namespace palpate

#endif
