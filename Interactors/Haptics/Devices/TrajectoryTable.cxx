// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/TrajectoryTable.h"

#include <cmath>
#include <limits>

namespace palpate::TrajectoryTable
{
namespace
{
enum Column : std::size_t
{
  Time = 0,
  Tip = 1,
  ContactPoint = 4,
  Deflection = 7,
  NormalForce = 8,
  Friction = 9,
  IdealForce = 12,
  State = 13,
  Position = 14,
  Velocity = 17,
  Buttons = 20,
  Valid = 21,
  Fresh = 22,
  SentForce = 23,
  Taken = 26,
  Memory = 27,
  Axis = 28,
  Torque = 31
};

/// Tolerance for the length of an axis that other programs have rounded.
constexpr double LengthTolerance = 1e-3;

void put(const Eigen::Vector3d& vector, Column column, Numbers& numbers)
{
  Eigen::Map<Eigen::Vector3d>(numbers.data() + column) = vector;
}

Eigen::Vector3d get(const Numbers& numbers, Column column)
{
  return Eigen::Map<const Eigen::Vector3d>(numbers.data() + column);
}

/// Whether `value` is a whole number from 0 to `most`.
bool isCount(double value, double most)
{
  return value >= 0.0 && value <= most && value == std::floor(value);
}
} // namespace

const std::array<std::string_view, ColumnCount> Names = { "time_s", "tip_x_mm", "tip_y_mm",
  "tip_z_mm", "contact_x_mm", "contact_y_mm", "contact_z_mm", "deflection_mm", "normal_force_N",
  "friction_x_N", "friction_y_N", "friction_z_N", "ideal_force_N", "state", "device_x_m",
  "device_y_m", "device_z_m", "velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s", "buttons",
  "valid", "fresh", "sent_x_N", "sent_y_N", "sent_z_N", "taken", "memory_force_N", "axis_x",
  "axis_y", "axis_z", "torque_x_Nmm", "torque_y_Nmm", "torque_z_Nmm" };

Numbers numbersOf(const TrajectoryRow& row)
{
  Numbers numbers{};
  numbers[Time] = row.time;
  put(row.tip, Tip, numbers);
  put(row.contact.contactPoint, ContactPoint, numbers);
  numbers[Deflection] = row.contact.deflection;
  numbers[NormalForce] = row.contact.normalForce;
  put(row.contact.friction, Friction, numbers);
  numbers[IdealForce] = row.idealForce;
  numbers[State] = static_cast<double>(row.contact.state);
  put(row.sample.position, Position, numbers);
  put(row.sample.velocity, Velocity, numbers);
  numbers[Buttons] = row.sample.buttons;
  numbers[Valid] = row.sample.valid ? 1.0 : 0.0;
  numbers[Fresh] = row.sample.fresh ? 1.0 : 0.0;
  put(row.sentForce, SentForce, numbers);
  numbers[Taken] = row.isTaken ? 1.0 : 0.0;
  numbers[Memory] = row.contact.memory;
  put(row.axis, Axis, numbers);
  put(row.contact.torque, Torque, numbers);
  return numbers;
}

std::string rowOf(const Numbers& numbers, bool hasContact, bool hasDevice, TrajectoryRow& row)
{
  row.time = numbers[Time];
  row.tip = get(numbers, Tip);
  row.axis = get(numbers, Axis);
  if (!row.axis.isZero(0.0) && !(std::abs(row.axis.norm() - 1.0) <= LengthTolerance))
  {
    return "axis_x, axis_y, axis_z must have the length 1, or be zero";
  }
  if (hasContact)
  {
    if (!isCount(numbers[State], static_cast<double>(ContactState::TiltedTooFar)))
    {
      return "state must be a whole number from 0 to 6";
    }
    row.contact.contactPoint = get(numbers, ContactPoint);
    row.contact.deflection = numbers[Deflection];
    row.contact.normalForce = numbers[NormalForce];
    row.contact.memory = numbers[Memory];
    row.contact.torque = get(numbers, Torque);
    row.contact.friction = get(numbers, Friction);
    row.idealForce = numbers[IdealForce];
    row.contact.state = static_cast<ContactState>(static_cast<int>(numbers[State]));
  }
  if (hasDevice)
  {
    if (!isCount(numbers[Buttons], std::numeric_limits<std::uint32_t>::max()))
    {
      return "buttons must be a whole number of 32 bits";
    }
    for (const Column flag : { Valid, Fresh, Taken })
    {
      if (!isCount(numbers[flag], 1.0))
      {
        return std::string(Names[flag]) + " must be 0 or 1";
      }
    }
    row.sample.position = get(numbers, Position);
    row.sample.velocity = get(numbers, Velocity);
    row.sample.buttons = static_cast<std::uint32_t>(numbers[Buttons]);
    row.sample.valid = numbers[Valid] == 1.0;
    row.sample.fresh = numbers[Fresh] == 1.0;
    row.sentForce = get(numbers, SentForce);
    row.isTaken = numbers[Taken] == 1.0;
  }
  return {};
}
} // namespace palpate::TrajectoryTable
