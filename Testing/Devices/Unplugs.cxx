// SPDX-License-Identifier: BSD-3-Clause
// Unplugs devices at random moments with the real hidapi. Checks that the first tick after the
// report of the loss is always without force, and measures the time from the unplugging to the end
// of this tick. See --help.
#include "PressingServo.h"
#include "PulledPlug.h"
#include "SampleResponses.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
struct Options
{
  int count = 1000;
  std::uint32_t seed = 1;
  std::string output;
};

struct Tally
{
  int pulls = 0;
  /// Number of pulls without force in the first tick after the report and in the next twenty ticks.
  int withoutForce = 0;
  int pressing = 0;          ///< number of pulls during which the motors had a force
  double strongest = 0.0;    ///< largest force of the motors at a pull, N
  std::vector<double> walls; ///< times from the pull to the end of the first tick without force, ms
};

/// Random moments: any phase of a press, and any time within a press and the pause after it.
class RandomMoments
{
public:
  explicit RandomMoments(std::uint32_t seed)
    : Random(seed)
  {
  }
  PullMoment next()
  {
    const double phase = this->share() * PressPeriod;
    const auto wait = static_cast<int>(1e6 * PressPeriod * this->share());
    return { phase, std::chrono::microseconds(wait) };
  }

private:
  /// Returns a random number from 0 to 1, the same on every machine; std::uniform_real_distribution
  /// does not guarantee this.
  double share() { return this->Random() / 4294967296.0; }
  std::mt19937 Random;
};

Tally pullAll(const Options& options)
{
  Tally tally;
  RandomMoments moments(options.seed);
  const std::shared_ptr<const ContactBody> plate = uniformBody(openPlate(10.0, 20));
  while (tally.pulls < options.count)
  {
    const PulledPlug pulled = pullPlug(plate, moments.next());
    ++tally.pulls;
    if (!pulled.fault.empty())
    {
      std::printf("pull %d: %s\n", tally.pulls, pulled.fault.c_str());
      continue;
    }
    ++tally.withoutForce;
    tally.pressing += pulled.motors > 0.0 ? 1 : 0;
    tally.strongest = std::max(tally.strongest, pulled.motors);
    tally.walls.push_back(pulled.wall);
  }
  std::sort(tally.walls.begin(), tally.walls.end());
  return tally;
}

/// Returns the smallest value for which at least the fraction `share` of all values is not larger;
/// 0 without values.
double quantile(const std::vector<double>& sorted, double share)
{
  const auto rank = std::max(std::ceil(share * static_cast<double>(sorted.size())), 1.0);
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(rank) - 1];
}

void printHistogram(const std::vector<double>& sorted)
{
  constexpr int Bars = 16;
  constexpr double Width = 50.0; // width of the longest bar in characters
  const double step = std::max(quantile(sorted, 0.99) / Bars, 0.01);
  std::vector<int> counts(Bars + 1, 0);
  for (const double wall : sorted)
  {
    const int bar = static_cast<int>(std::max(wall, 0.0) / step);
    ++counts[static_cast<std::size_t>(std::min(bar, Bars))];
  }
  const int most = std::max(*std::max_element(counts.begin(), counts.end()), 1);
  for (int bar = 0; bar <= Bars; ++bar)
  {
    const int count = counts[static_cast<std::size_t>(bar)];
    const auto length = static_cast<std::size_t>(std::ceil(Width * count / most));
    std::printf(bar < Bars ? "  from %6.2f ms %5d %s\n" : "  above%6.2f ms %5d %s\n", bar * step,
      count, std::string(length, '#').c_str());
  }
}

using Figures = std::vector<std::pair<const char*, double>>;

Figures figuresOf(const Options& options, const Tally& tally)
{
  return { { "seed", options.seed }, { "unplugs", tally.pulls },
    { "first_tick_without_force", tally.withoutForce }, { "pulled_while_pressing", tally.pressing },
    { "strongest_force_N", tally.strongest }, { "wall_min_ms", quantile(tally.walls, 0.0) },
    { "wall_median_ms", quantile(tally.walls, 0.5) }, { "wall_p90_ms", quantile(tally.walls, 0.9) },
    { "wall_p99_ms", quantile(tally.walls, 0.99) }, { "wall_max_ms", quantile(tally.walls, 1.0) } };
}

bool write(const std::string& path, bool passed, const Figures& figures)
{
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file)
  {
    return false;
  }
  std::fprintf(
    file, "{\"part\": \"unplugs\", \"passed\": %s, \"figures\": {", passed ? "true" : "false");
  const char* comma = "";
  for (const auto& [name, value] : figures)
  {
    std::fprintf(file, "%s\"%s\": %.10g", comma, name, value);
    comma = ", ";
  }
  std::fputs("}}\n", file);
  const bool whole = std::ferror(file) == 0;
  return std::fclose(file) == 0 && whole;
}
} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app{ "Unplugs a force device at random moments while it presses on a plate five times a "
                "second. To be run by umockdev-wrapper.",
    "palpateUnplugs" };
  app.add_option("--count", options.count, "how often")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--seed", options.seed, "of the moments")->capture_default_str();
  app.add_option("--output", options.output, "also write the figures there, a .json");
  CLI11_PARSE(app, argc, argv);

  const Tally tally = pullAll(options);
  // There is a force for most of a press, so a force is expected at more than half of the moments.
  const bool passed = tally.withoutForce == tally.pulls && 2 * tally.pressing > tally.pulls;
  const Figures figures = figuresOf(options, tally);
  for (const auto& [name, value] : figures)
  {
    std::printf("%-26s %.10g\n", name, value);
  }
  std::printf("from the pull to the end of the first tick without force:\n");
  printHistogram(tally.walls);
  if (!options.output.empty() && !write(options.output, passed, figures))
  {
    std::fprintf(stderr, "palpateUnplugs: cannot write '%s'\n", options.output.c_str());
    return 1;
  }
  std::printf(passed ? "passed\n" : "FAILED\n");
  return passed ? 0 : 1;
}
