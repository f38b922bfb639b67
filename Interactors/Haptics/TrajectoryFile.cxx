// SPDX-License-Identifier: BSD-3-Clause
#include "TrajectoryFile.h"

#include <array>
#include <charconv>
#include <fstream>

namespace palpate
{
namespace
{
void append(std::string& line, double value)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  line.append(buffer.data(), end);
  line += ',';
}

void append(std::string& line, const Eigen::Vector3d& vector)
{
  append(line, vector.x());
  append(line, vector.y());
  append(line, vector.z());
}
} // namespace

const char* const TrajectoryColumns =
  "time_s,tip_x_mm,tip_y_mm,tip_z_mm,contact_x_mm,contact_y_mm,contact_z_mm,deflection_mm,"
  "normal_force_N,friction_x_N,friction_y_N,friction_z_N,ideal_force_N,state";

std::string writeTrajectory(const std::string& path, const std::vector<ServoTick>& ticks)
{
  std::ofstream file(path, std::ios::binary);
  file << TrajectoryColumns << '\n';
  std::string line;
  for (const ServoTick& tick : ticks)
  {
    line.clear();
    append(line, tick.time);
    append(line, tick.tip);
    append(line, tick.contact.contactPoint);
    append(line, tick.contact.deflection);
    append(line, tick.contact.normalForce);
    append(line, tick.contact.friction);
    append(line, tick.contact.force.norm());
    line += std::to_string(static_cast<int>(tick.contact.state));
    file << line << '\n';
  }
  file.close();
  return file ? std::string() : "cannot write '" + path + "'";
}
} // namespace palpate
