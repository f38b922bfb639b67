// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrajectoryTable_h
#define palpate_TrajectoryTable_h

#include "Haptics/Devices/Trajectory.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

/// The columns of a trajectory file: their names, and the conversions from rows to numbers and from
/// numbers to rows.
namespace palpate::TrajectoryTable
{
constexpr std::size_t ContactBegin = 4; ///< columns before this one: time and tip
constexpr std::size_t DeviceBegin = 14;
/// Column of the contact's memory force, present if the body relaxes.
constexpr std::size_t MemoryBegin = 27;
constexpr std::size_t AxisBegin = 28;
constexpr std::size_t TorqueBegin = 31; ///< first column of the contact's torque
constexpr std::size_t ColumnCount = 34;

extern const std::array<std::string_view, ColumnCount> Names;
using Numbers = std::array<double, ColumnCount>;

Numbers numbersOf(const TrajectoryRow& row);
/// Converts numbers to a row. Reads the contact from the numbers of [ContactBegin, DeviceBegin) if
/// `hasContact`, and the device from [DeviceBegin, MemoryBegin) if `hasDevice`. Returns the first
/// fault of these numbers or of the axis, or "" if there is no fault.
std::string rowOf(const Numbers& numbers, bool hasContact, bool hasDevice, TrajectoryRow& row);
} // namespace palpate::TrajectoryTable

#endif
