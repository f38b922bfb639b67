// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrajectoryTable_h
#define palpate_TrajectoryTable_h

#include "Haptics/Devices/Trajectory.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

/// The columns of a trajectory file: their names, and the conversion of rows to numbers and back.
namespace palpate::TrajectoryTable
{
constexpr std::size_t ContactBegin = 4; ///< the preceding columns are time and tip
constexpr std::size_t DeviceBegin = 14;
constexpr std::size_t MemoryBegin = 27; ///< memory force of the contact, if the body relaxes
constexpr std::size_t AxisBegin = 28;
constexpr std::size_t TorqueBegin = 31; ///< torque of the contact
constexpr std::size_t ColumnCount = 34;

extern const std::array<std::string_view, ColumnCount> Names;
using Numbers = std::array<double, ColumnCount>;

Numbers numbersOf(const TrajectoryRow& row);
/// Converts numbers to a row. Uses the numbers of [ContactBegin, DeviceBegin) if `hasContact`, and
/// those of [DeviceBegin, MemoryBegin) if `hasDevice`. Returns the first fault of these numbers or
/// of the axis, or "".
std::string rowOf(const Numbers& numbers, bool hasContact, bool hasDevice, TrajectoryRow& row);
} // namespace palpate::TrajectoryTable

#endif
