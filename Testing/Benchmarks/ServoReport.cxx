// SPDX-License-Identifier: BSD-3-Clause
#include "ServoReport.h"

#include <cinttypes>
#include <cstdio>

namespace palpate::benchmarks
{
namespace
{
double microseconds(const LatencyCounts& times, double share)
{
  return 1e-3 * static_cast<double>(times.quantile(share));
}

double worst(const LatencyCounts& times)
{
  return 1e-3 * static_cast<double>(times.worst());
}
} // namespace

bool writeServoCsv(const std::string& path, const std::vector<ServoRow>& rows)
{
  std::FILE* const file = std::fopen(path.c_str(), "w");
  if (file == nullptr)
  {
    return false;
  }
  std::fputs(
    "rate_hz,load,policy,wakeup_median_us,p99,p999,max,tick_median_us,tick_p99,missed,ticks\n",
    file);
  for (const ServoRow& row : rows)
  {
    const ServoStatistics& s = row.statistics;
    std::fprintf(file, "%.0f,%s,%s,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%" PRIu64 ",%" PRIu64 "\n",
      row.rate, row.load.c_str(), row.policy.c_str(), microseconds(s.wakeUp, 0.5),
      microseconds(s.wakeUp, 0.99), microseconds(s.wakeUp, 0.999), worst(s.wakeUp),
      microseconds(s.tick, 0.5), microseconds(s.tick, 0.99), s.missed, s.ticks);
  }
  const bool failed = std::ferror(file) != 0;
  return std::fclose(file) == 0 && !failed;
}

void printServoHeader()
{
  std::printf("\n%6s %-10s %-12s | %-35s | %-26s |\n", "", "", "", "wake-up, µs", "tick, µs");
  std::printf("%6s %-10s %-12s | %8s %8s %8s %8s | %8s %8s %8s | %7s %7s\n", "Hz", "load", "policy",
    "median", "p99", "p99.9", "max", "median", "p99", "max", "missed", "ticks");
}

void printServoRow(const ServoRow& row)
{
  const ServoStatistics& s = row.statistics;
  std::printf("%6.0f %-10s %-12s | %8.1f %8.1f %8.1f %8.0f | %8.1f %8.1f %8.0f | %7" PRIu64
              " %7" PRIu64 "\n",
    row.rate, row.load.c_str(), row.policy.c_str(), microseconds(s.wakeUp, 0.5),
    microseconds(s.wakeUp, 0.99), microseconds(s.wakeUp, 0.999), worst(s.wakeUp),
    microseconds(s.tick, 0.5), microseconds(s.tick, 0.99), worst(s.tick), s.missed, s.ticks);
  std::fflush(stdout);
}
} // namespace palpate::benchmarks
