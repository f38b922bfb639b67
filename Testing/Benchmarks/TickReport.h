// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_TickReport_h
#define palpate_benchmarks_TickReport_h

#include "TickTimes.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::benchmarks
{
/// Results of one method on one body.
struct TickRow
{
  std::string method;
  std::size_t triangles;
  double buildSeconds;
  double megabytes;
  int tipsPerCall;
  TickTimes times;
};

/// Writes method,triangles,cache,median_ns,p99_ns,p999_ns,max_ns,build_s,memory_mb; two lines per
/// row, hot and cold. Returns false if the file cannot be written.
bool writeTickCsv(const std::string& path, const std::vector<TickRow>& rows);

/// Prints the rows of one body, with their ratio to palpate-point with the same state of the
/// caches.
void printRows(const std::vector<TickRow>& rows, std::size_t triangles);

/// Prints targets and measured values of the largest body, and the ratio of these values to those
/// of the smallest body.
void printTargets(const std::vector<TickRow>& rows);
} // namespace palpate::benchmarks

#endif
