// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary text as a trajectory or recording. The result is an error that names a line, or rows
// that are finite and in the order of time. The rows are bitwise unchanged after writing and
// reading, and can be replayed.
#include "MemoryFile.h"
#include "Haptics/Devices/ReplayDevice.h"
#include "Require.h"
#include "Haptics/Devices/TrajectoryFile.h"
#include "Haptics/Devices/TrajectoryTable.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

using namespace palpate;
using namespace palpate::testing;

namespace
{
bool haveSameBits(const TrajectoryRow& a, const TrajectoryRow& b)
{
  const TrajectoryTable::Numbers first = TrajectoryTable::numbersOf(a);
  const TrajectoryTable::Numbers second = TrajectoryTable::numbersOf(b);
  return std::memcmp(first.data(), second.data(), sizeof first) == 0;
}

void checkRows(const Trajectory& trajectory)
{
  double last = -std::numeric_limits<double>::infinity();
  for (const TrajectoryRow& row : trajectory.rows)
  {
    for (const double number : TrajectoryTable::numbersOf(row))
    {
      require(std::isfinite(number), "rows are finite");
    }
    require(row.time >= last, "time does not decrease");
    last = row.time;
  }
}

void checkRoundTrip(const Trajectory& trajectory)
{
  static MemoryFile file;
  file.hold("", 0);
  require(writeTrajectory(file.path(), trajectory).empty(), "what was read can be written");
  std::ifstream stream(file.path());
  Trajectory again;
  require(readTrajectory(stream, "again", again).empty(), "what was written can be read");
  require(again.rows.size() == trajectory.rows.size() &&
      again.hasContact == trajectory.hasContact && again.hasDevice == trajectory.hasDevice &&
      again.hasAxis == trajectory.hasAxis && again.hasTorque == trajectory.hasTorque,
    "nothing is lost");
  for (std::size_t i = 0; i < again.rows.size(); ++i)
  {
    require(haveSameBits(again.rows[i], trajectory.rows[i]), "the same bits come back");
  }
}

void checkReplay(const Trajectory& trajectory)
{
  ReplayDevice device(trajectory, WorkspaceMapping());
  const double begin = device.begin();
  const double end = device.duration();
  for (const double share : { -0.1, 0.0, 0.3, 0.5, 1.0, 1.1 })
  {
    const DeviceSample sample = device.read(begin + share * (end - begin));
    require(!sample.valid ||
        (sample.position.allFinite() && sample.velocity.allFinite() &&
          sample.orientation.coeffs().allFinite()),
      "a valid sample is finite");
  }
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
  Trajectory trajectory;
  const std::string error = readTrajectory(stream, "fuzz", trajectory);
  if (!error.empty())
  {
    require(error.rfind("fuzz", 0) == 0, "an error names the file");
    require(trajectory.rows.empty(), "after an error nothing is half-loaded");
    return 0;
  }
  require(!trajectory.rows.empty(), "a trajectory without rows is an error");
  checkRows(trajectory);
  checkRoundTrip(trajectory);
  checkReplay(trajectory);
  return 0;
}
