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
 * ideal force (magnitude of the total, before any limit of the device) and contact state. Below the
 * names of the columns stand lines "# tool: sphere:6.35" with the setups that were in use
 * (RecordedSetups). The
 * contact is that of one scene, also while the sent force passes to another scene. If at least one
 * tick has such values, these columns follow: memory_force_N, the memory part of the
 * normal force (Contact::memory); axis_x..., the tool's axis from tip to hand (zero: unknown);
 * torque_x_Nmm..., the torque on the tool about its tip. Body frame; s, mm, N. Numbers are the
 * shortest decimals that are read back to the same bits; a missing value (no contact) is 0. A tick
 * whose sample is not valid or not finite has a tip of 0 and state 5. Returns an error that names
 * the file and the reason, or "".
 *
 * An old file is kept until the new one is complete (WholeFile). If the disk is full, the rows
 * written so far are kept in PATH.part, because they cannot be recorded again. The incomplete file
 * can be read, and the error contains its number of rows.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const std::vector<Tick>& ticks,
  const RecordedSetups& setups = RecordedSetups());

/**
 * Writes a trajectory: time and tip, and if the trajectory contains them, the columns of the
 * contact and of the device. The columns of the device are device_x_m,device_y_m,device_z_m,
 * velocity_x_m_s..., buttons,valid,fresh (0 or 1), sent_x_N... (the force written to the device),
 * taken (0 or 1: whether the device accepted the force). The last columns, if present, are
 * memory_force_N, axis and torque. Numbers that are not finite, and times that decrease, are errors
 * that name the row (from 0) and the column.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const Trajectory& trajectory);

/**
 * Reads files of writeTrajectory, bit for bit, and other CSV files (CsvReader). Columns may be in
 * any order, and other columns may be present. time_s and the three tip_*_mm are required. The ten
 * columns of the contact, the thirteen of the device and the three of the axis are optional, but
 * each group must be complete. memory_force_N and the three columns of the torque may be present
 * together with those of the contact. Lines of setups are optional, also each part of them.
 *
 * Returns an error, "file:line: fault", or "". Errors are: a missing or duplicate column, a line
 * with too few or too many fields, a field that is not a finite number, a state, button or flag
 * that does not exist, an axis whose length is neither 1 (to 1e-3) nor 0, a time that decreases, a
 * file without lines. After an error `trajectory` is unchanged.
 */
PALPATE_EXPORT std::string readTrajectory(const std::string& path, Trajectory& trajectory);

/// Reads a trajectory from a stream; `name` replaces the file name in errors.
PALPATE_EXPORT std::string readTrajectory(
  std::istream& stream, const std::string& name, Trajectory& trajectory);
} // namespace palpate

#endif
