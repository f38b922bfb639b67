// SPDX-License-Identifier: BSD-3-Clause
#include "TickReport.h"

#include <algorithm>
#include <cstdio>

namespace palpate::benchmarks
{
namespace
{
const TickRow* findRow(
  const std::vector<TickRow>& rows, const std::string& method, std::size_t triangles)
{
  const auto found = std::find_if(rows.begin(), rows.end(),
    [&](const TickRow& row) { return row.method == method && row.triangles == triangles; });
  return found == rows.end() ? nullptr : &*found;
}

void printTarget(const char* what, double target, double measured, const char* unit)
{
  std::printf("  %-52s %8.4g %9.4g %-2s  %s\n", what, target, measured, unit,
    measured <= target ? "met" : "MISSED");
}
} // namespace

bool writeTickCsv(const std::string& path, const std::vector<TickRow>& rows)
{
  std::FILE* const file = std::fopen(path.c_str(), "w");
  if (file == nullptr)
  {
    return false;
  }
  std::fputs("method,triangles,cache,median_ns,p99_ns,p999_ns,max_ns,build_s,memory_mb\n", file);
  for (const TickRow& row : rows)
  {
    const auto line = [&](const char* cache, const CallTimes& t)
    {
      std::fprintf(file, "%s,%zu,%s,%.1f,%.1f,%.1f,%.1f,%.4f,%.1f\n", row.method.c_str(),
        row.triangles, cache, t.median, t.p99, t.p999, t.maximum, row.buildSeconds, row.megabytes);
    };
    line("hot", row.times.hot);
    line("cold", row.times.cold);
  }
  const bool failed = std::ferror(file) != 0;
  return std::fclose(file) == 0 && !failed;
}

void printRows(const std::vector<TickRow>& rows, std::size_t triangles)
{
  const TickRow* const point = findRow(rows, "palpate-point", triangles);
  std::printf("\n%zu triangles, ns per call\n  %-22s %-9s %9s %9s %9s %9s %9s %8s %7s %7s %6s\n",
    triangles, "method", "cache", "median", "p99", "p99.9", "max", "mean", "calls", "x point",
    "build s", "MB");
  for (const TickRow& row : rows)
  {
    if (row.triangles != triangles)
    {
      continue;
    }
    const auto line = [&](const char* cache, const CallTimes& t, const CallTimes* reference)
    {
      std::printf("  %-22s %-9s %9.0f %9.0f %9.0f %9.0f %9.0f %8zu %7.1f %7.2f %6.0f\n",
        row.method.c_str(), cache, t.median, t.p99, t.p999, t.maximum, t.mean, t.calls,
        reference != nullptr ? t.median / reference->median : 0.0, row.buildSeconds, row.megabytes);
    };
    line("hot", row.times.hot, point != nullptr ? &point->times.hot : nullptr);
    line("cold", row.times.cold, point != nullptr ? &point->times.cold : nullptr);
    if (row.times.warmCode.calls > 0)
    {
      line("code warm", row.times.warmCode, nullptr);
    }
    if (row.tipsPerCall > 1)
    {
      std::printf("  %-22s %-9s %9.0f hot, %.0f cold\n", "  per tip", "",
        row.times.hot.median / row.tipsPerCall, row.times.cold.median / row.tipsPerCall);
    }
  }
  std::fflush(stdout);
}

void printTargets(const std::vector<TickRow>& rows)
{
  if (rows.empty())
  {
    return;
  }
  const auto smaller = [](const TickRow& a, const TickRow& b) { return a.triangles < b.triangles; };
  const auto [least, most] = std::minmax_element(rows.begin(), rows.end(), smaller);
  const TickRow* const tick = findRow(rows, "palpate-tick", most->triangles);
  const TickRow* const onset = findRow(rows, "palpate-onset-tick", most->triangles);
  const TickRow* const first = findRow(rows, "palpate-tick", least->triangles);
  const TickRow* const mixed = findRow(rows, "palpate-tick-shuffled", most->triangles);
  if (tick == nullptr || onset == nullptr || first == nullptr)
  {
    return;
  }
  std::printf("\n%zu triangles: targets (set for 4 million) and measured\n", most->triangles);
  printTarget("tick, hot, median", 150.0, tick->times.hot.median, "ns");
  printTarget("tick, hot, mean", 250.0, tick->times.hot.mean, "ns");
  printTarget("tick, hot, p99.9", 2000.0, tick->times.hot.p999, "ns");
  printTarget("tick, cold, median", 3000.0, tick->times.cold.median, "ns");
  printTarget("tick, cold, p99", 6000.0, tick->times.cold.p99, "ns");
  printTarget("contact onset, hot, median", 2000.0, onset->times.hot.median, "ns");
  printTarget("building the kernel's copy", 3.0, tick->buildSeconds, "s");
  printTarget("its memory: responses 160, mesh 400", 560.0, tick->megabytes, "MB");
  if (mixed != nullptr)
  {
    // No effect is expected; 1.1 allows for the difference between two runs.
    printTarget("tick, hot, median, input shuffled over in order", 1.1,
      mixed->times.hot.median / tick->times.hot.median, "");
  }
  if (first != tick)
  {
    const std::string what =
      "tick, hot, median over that of " + std::to_string(first->triangles) + " triangles";
    printTarget(what.c_str(), 1.5, tick->times.hot.median / first->times.hot.median, "");
  }
}
} // namespace palpate::benchmarks
