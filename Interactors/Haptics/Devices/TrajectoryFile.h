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
 * Writes ticks as CSV, one line per tick. The columns are time, tip, contact point, deflection,
 * normal force, friction, ideal force (magnitude of the total force before any limit of the device)
 * and contact state. Lines such as "# tool: sphere:6.35" below the column names give the setups
 * that were in use (RecordedSetups). During a change of the scene, the contact is that of the new
 * scene alone. The following columns are added if at least one tick has a value for them:
 * memory_force_N, the memory part of the normal force (Contact::memory); axis_x..., the tool's axis
 * from tip to hand, zero if unknown; torque_x_Nmm..., the torque on the tool about its tip. All
 * values are in the body frame, in s, mm and N. Numbers are written as the shortest decimals that
 * are read back to the same bits. Values are 0 if there is no contact. A tick whose sample is not
 * valid or not finite has the tip (0, 0, 0) and state 5. Returns "", or an error that names the
 * file and the reason.
 *
 * An old file is kept until the new one is complete (WholeFile). If the disk is full, the rows
 * written so far are kept in PATH.part, because they cannot be recorded again. readTrajectory can
 * read the incomplete file, and the error contains the number of its rows.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const std::vector<Tick>& ticks,
  const RecordedSetups& setups = RecordedSetups());

/**
 * Writes a trajectory. The columns are time and tip, followed by those of the contact and of the
 * device if the trajectory contains them. The columns of the device are
 * device_x_m,device_y_m,device_z_m, velocity_x_m_s..., buttons,valid,fresh (0 or 1), sent_x_N...
 * (the force written to the device), taken (0 or 1: whether the device accepted the force). The
 * last columns are memory_force_N, axis and torque, if the trajectory contains them. Numbers that
 * are not finite, and times that decrease, are errors that name the row (from 0) and the column.
 */
PALPATE_EXPORT std::string writeTrajectory(const std::string& path, const Trajectory& trajectory);

/**
 * Reads files written by writeTrajectory, bit for bit, and other CSV files (CsvReader). Columns may
 * be in any order, and other columns may be present. time_s and the three tip_*_mm are required.
 * The ten columns of the contact, the thirteen of the device and the three of the axis are
 * optional, but each group must be complete. memory_force_N and the three columns of the torque may
 * be present if those of the contact are. The lines with setups are optional, and so is each part
 * of a setup.
 *
 * Returns "", or an error "file:line: fault". Errors are: a missing or duplicate column, a line
 * with too few or too many fields, a field that is not a finite number, a state, button or flag
 * that does not exist, an axis whose length is neither 1 (to 1e-3) nor 0, a time that decreases, a
 * file without lines. After an error `trajectory` is unchanged.
 */
PALPATE_EXPORT std::string readTrajectory(const std::string& path, Trajectory& trajectory);

/// Reads a trajectory from a stream. Errors contain `name` instead of a file name.
PALPATE_EXPORT std::string readTrajectory(
  std::istream& stream, const std::string& name, Trajectory& trajectory);
} // namespace palpate

#endif
