// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_ServoReport_h
#define palpate_benchmarks_ServoReport_h

#include "Haptics/Servo/ServoMeter.h"

#include <string>
#include <vector>

namespace palpate::benchmarks
{
/// Results of one rate under one load with one scheduling policy.
struct ServoRow
{
  double rate;
  std::string load;
  std::string policy;
  ServoStatistics statistics;
};

/// Writes rate_hz,load,policy,wakeup_median_us,p99,p999,max,tick_median_us,tick_p99,missed,ticks.
/// All times are in µs. Returns false if the file cannot be written.
bool writeServoCsv(const std::string& path, const std::vector<ServoRow>& rows);

void printServoHeader();
void printServoRow(const ServoRow& row);
} // namespace palpate::benchmarks

#endif
