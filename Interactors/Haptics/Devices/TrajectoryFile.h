// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrajectoryFile_h
#define palpate_TrajectoryFile_h

#include "Mechanics/PalpateExport.h"
#include "Haptics/Servo/ServoStep.h"
#include "Haptics/Devices/Trajectory.h"

#include <istream>
#include <string>
#include <vector>

namespace palpate
{
/**
 * Writes one line per tick as CSV: time, tip, contact point, deflection, normal force, friction,
 * ideal force (magnitude of the total, before any limit of the device), contact state, and, if any
 * tick has them, memory_force_N, the memory part of the normal force (Contact::memory), axis_x...,
 * the tool's axis from tip to hand (zero: not known), and torque_x_Nmm..., on the tool about its
 * tip. Body frame; s, mm, N. Numbers are the shortest decimals that read back to the same bits; a
 * column without a value (no contact) is 0. A tick that had no valid sample, or one that is not
 * finite, has a tip of 0 and state 5. Returns an error that names the file and the reason, or "".
 *
 * An old file is kept until the new one is complete (WholeFile). If the disk is full, the rows
 * written so far are kept in PATH.part, a readable file, as they cannot be recorded again; the
 * error says how many.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const std::vector<Tick>& ticks);

/**
 * The same for a trajectory: time and tip, the columns of the contact if it has one, and if it has
 * a device's: device_x_m,device_y_m,device_z_m, velocity_x_m_s..., buttons,valid,fresh (0 or 1),
 * sent_x_N... (the force written to the device), taken (0 or 1; by the device); last, if it has
 * them, memory_force_N, axis and torque. Numbers that are not finite, and times that decrease, are
 * errors naming the row (from 0) and the column.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const Trajectory& trajectory);

/**
 * Reads files of writeTrajectory to the same bits, and others (CsvReader): columns may be in any
 * order, among others. Required are time_s and the three of tip_*_mm; all or none of the contact's
 * ten, which memory_force_N and the three of torque may follow; all or none of the device's
 * thirteen and of the axis's three.
 *
 * Errors, as "file:line: what is wrong", and "" for none: a missing or duplicate column, a line
 * with too few or too many fields, a field that is not a finite number, a state, button or flag
 * that does not exist, an axis whose length is neither 1, to 1e-3, nor 0, time that decreases, no
 * lines. After an error `trajectory` is unchanged.
 */
PALPATE_EXPORT std::string readTrajectory(const std::string& path, Trajectory& trajectory);

/// The same from a stream; `name` stands for the file in errors.
PALPATE_EXPORT std::string readTrajectory(
  std::istream& stream, const std::string& name, Trajectory& trajectory);
} // namespace palpate

#endif
