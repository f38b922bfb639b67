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
 * ideal force (magnitude of the total, before any limit of the device) and contact state. If any
 * tick has them, these follow: memory_force_N, the memory part of the normal force
 * (Contact::memory); axis_x..., the tool's axis from tip to hand (zero: unknown); torque_x_Nmm...,
 * the torque on the tool about its tip. Body frame; s, mm, N. Numbers are the shortest decimals
 * that read back to the same bits; a column without a value (no contact) is 0. A tick whose sample
 * is not valid or not finite has a tip of 0 and state 5. Returns an error that names the file and
 * the reason, or "".
 *
 * An old file is kept until the new one is complete (WholeFile). If the disk is full, the rows
 * written so far are kept in PATH.part, because they cannot be recorded again. This file can be
 * read, and the error gives its number of rows.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const std::vector<Tick>& ticks);

/**
 * The same for a trajectory: time and tip; the columns of the contact if it has them; the columns
 * of the device if it has them. These are device_x_m,device_y_m,device_z_m, velocity_x_m_s...,
 * buttons,valid,fresh (0 or 1), sent_x_N... (the force written to the device), taken (0 or 1:
 * whether the device accepted the force). Last come memory_force_N, axis and torque if it has them.
 * Numbers that are not finite, and times that decrease, are errors that name the row (from 0) and
 * the column.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const Trajectory& trajectory);

/**
 * Reads files of writeTrajectory to the same bits, and other CSV files (CsvReader). Columns may be
 * in any order, and other columns may be present. Required are time_s and the three of tip_*_mm.
 * Optional, but complete, are the contact's ten columns, the device's thirteen and the axis's
 * three. With those of the contact there may be memory_force_N and the three of torque.
 *
 * Returns an error, "file:line: fault", or "". Errors are: a missing or duplicate column, a line
 * with too few or too many fields, a field that is not a finite number, a state, button or flag
 * that does not exist, an axis whose length is neither 1 (to 1e-3) nor 0, a time that decreases, no
 * lines. After an error `trajectory` is unchanged.
 */
PALPATE_EXPORT std::string readTrajectory(const std::string& path, Trajectory& trajectory);

/// The same from a stream; `name` is the name of the file in errors.
PALPATE_EXPORT std::string readTrajectory(
  std::istream& stream, const std::string& name, Trajectory& trajectory);
} // namespace palpate

#endif
