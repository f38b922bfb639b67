// SPDX-License-Identifier: BSD-3-Clause
// A tick compared with other ways to find a closest point, in one run. A tip slides about 1 mm deep
// along a bumpy sphere, 0.1 mm per tick, over bodies of 20 thousand to 4 million triangles, with
// hot and with cold caches. The results are compared first; methods that disagree are not timed.
// See README.md.
#include "BumpySphere.h"
#include "ColdRead.h"
#include "Contact/ContactBody.h"
#include "ProcessMemory.h"
#include "TickReport.h"
#include "vtkSMPTools.h"

#include <CLI/CLI.hpp>

#include <malloc.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <thread>

namespace
{
using namespace palpate::benchmarks;
using palpate::ContactBody;
using palpate::Vector3;
using palpate::testing::ResponseStore;
using palpate::testing::Surface;

constexpr double Depth = 1.0;
constexpr double Step = 0.1;

struct Options
{
  std::vector<double> triangles{ 20e3, 200e3, 2e6, 4e6 };
  std::string output = ".";
  std::size_t hotCalls = 200000;
  std::size_t coldCalls = 2000;
  std::size_t checkedCalls = 2000;
  bool shuffled = false;
  bool own = false;
  bool quick = false;
};

/// The tips of all calls: one tip per call, and one patch of tips per call.
struct Paths
{
  std::vector<Vector3> single;
  std::vector<Vector3> patch;
};

Paths makePaths(const Options& options)
{
  Paths paths;
  const std::size_t calls = options.hotCalls + TickTimer::UncountedCalls;
  paths.single = palpate::testing::windingTips(calls, Depth, Step);
  // Each patch has ten tips across a finger of 10 mm and five tips along the finger.
  const std::size_t patches = options.hotCalls / 10 + TickTimer::UncountedCalls;
  paths.patch.reserve(PatchTips * patches);
  for (std::size_t i = 0; i < patches; ++i)
  {
    for (int tip = 0; tip < PatchTips; ++tip)
    {
      const double along = Step * static_cast<double>(i) + 5.0 / 4.0 * (tip / 10);
      const double across = 10.0 / 9.0 * (tip % 10) - 5.0;
      paths.patch.push_back(palpate::testing::windingTip(Depth, along, across));
    }
  }
  return paths;
}

double residentMegabytes()
{
  malloc_trim(0);
  return palpate::testing::residentMemory() / 1e6;
}

struct BuildCost
{
  double seconds;
  double megabytes;
};

BuildCost costOf(const std::function<void()>& build)
{
  const double before = residentMegabytes();
  const auto start = std::chrono::steady_clock::now();
  build();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return { passed.count(), residentMegabytes() - before };
}

/// The bodies for one size and the methods on them.
struct Field
{
  std::unique_ptr<ContactBody> body;
  std::unique_ptr<ContactBody> shuffledBody;
  std::array<std::unique_ptr<ContactBody>, 2> compactBodies;
  std::vector<Contender> contenders; ///< destroyed before the bodies
  std::size_t leaders = 0;           ///< number of Palpate's methods, which come first
};

BuildCost buildPalpate(const Surface& surface, std::unique_ptr<ContactBody>& body)
{
  const ResponseStore responses = bumpyResponses(surface);
  return costOf([&] { body = makePalpateBody(surface, responses); });
}

void addPalpate(Field& field, const Surface& surface, const Paths& paths)
{
  const BuildCost cost = buildPalpate(surface, field.body);
  const auto add = [&](const char* name, std::unique_ptr<TimedMethod> method, int tips)
  {
    field.contenders.push_back({ name, std::move(method), cost.seconds, cost.megabytes, tips,
      tips > 1 ? &paths.patch : &paths.single });
  };
  add("palpate-tick", makePalpateTick(*field.body), 1);
  add("palpate-point", makePalpatePoint(*field.body), 1);
  add("palpate-onset-point", makePalpateOnset(*field.body), 1);
  add("palpate-onset-tick", makePalpateOnsetTick(*field.body), 1);
  add("palpate-tick-servo", makePalpateServo(*field.body), 1);
  add("palpate-tick-50-tips", makePalpatePatch(*field.body), PatchTips);
}

/// Adds the methods on responses in the compact form: one law for all points, and four laws
/// combined at each point.
void addCompact(Field& field, const Surface& surface, const Paths& paths)
{
  const ResponseStore responses = bumpyResponses(surface);
  constexpr std::array<int, 2> laws{ 1, 4 };
  constexpr std::array<const char*, 2> names{ "palpate-tick-1-law", "palpate-tick-4-laws" };
  for (std::size_t k = 0; k < laws.size(); ++k)
  {
    std::unique_ptr<ContactBody>& body = field.compactBodies[k];
    const BuildCost cost = costOf([&] { body = makeCompactBody(surface, responses, laws[k]); });
    field.contenders.push_back(
      { names[k], makePalpateTick(*body), cost.seconds, cost.megabytes, 1, &paths.single });
  }
}

void addShuffled(Field& field, const Surface& surface, const Paths& paths)
{
  const BuildCost cost = buildPalpate(surface, field.shuffledBody);
  field.contenders.push_back({ "palpate-tick-shuffled", makePalpateTick(*field.shuffledBody),
    cost.seconds, cost.megabytes, 1, &paths.single });
}

void addPeers(Field& field, const Surface& surface, const Paths& paths)
{
  const auto add = [&](
                     const char* name, std::unique_ptr<TimedMethod> (*make)(const Surface& surface))
  {
    std::unique_ptr<TimedMethod> method;
    const BuildCost cost = costOf([&] { method = make(surface); });
    if (method)
    {
      field.contenders.push_back(
        { name, std::move(method), cost.seconds, cost.megabytes, 1, &paths.single });
    }
  };
  add("cgal-point", makeCgalPoint);
  add("embree-point", makeEmbreePoint);
  add("vtk-static-point", makeVtkStaticPoint);
}

/// Returns the largest distance of a point of the body from its given position, mm. The distance is
/// not 0, because coordinates are stored as floats.
double coordinateRounding(const Surface& surface)
{
  double extent = 0.0;
  for (const Vector3& p : surface.points)
  {
    extent = std::max(extent, p.cwiseAbs().maxCoeff());
  }
  const auto largest = static_cast<float>(extent);
  const float ulp = std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
  return 0.5 * std::sqrt(3.0) * static_cast<double>(ulp);
}

std::vector<double> distances(const Contender& contender, std::size_t calls)
{
  std::vector<double> found;
  contender.method->reset();
  for (std::size_t call = 0; call < calls; ++call)
  {
    contender.method->time(
      contender.tips->data() + call * static_cast<std::size_t>(contender.tipsPerCall));
    found.push_back(contender.method->distance());
  }
  return found;
}

/// Returns the expected distance for each call of a contender: the distance to the followed point.
/// For several tips it is the sum of the distances to their points, each found by a global search.
std::vector<double> expectedDistances(
  const Contender& contender, const Field& field, std::size_t calls)
{
  if (contender.tipsPerCall == 1)
  {
    return distances(field.contenders[1], calls);
  }
  Contender single{ "", makePalpateOnset(*field.body), 0.0, 0.0, 1, contender.tips };
  const auto tips = static_cast<std::size_t>(contender.tipsPerCall);
  const std::vector<double> each = distances(single, calls * tips);
  std::vector<double> sums(calls, 0.0);
  for (std::size_t i = 0; i < each.size(); ++i)
  {
    sums[i / tips] += each[i];
  }
  return sums;
}

/**
 * Compares all methods with Palpate's followed point. Both find the closest point of the whole
 * body. If one of the two stores the points as floats, the distances differ by at most the rounding
 * of the floats; if both do, by at most twice this rounding. A followed contact in a local minimum
 * would be farther away, but at a depth of 1 mm this body has no local minimum.
 */
bool agree(const Field& field, const Surface& surface, std::size_t calls)
{
  const double rounding = coordinateRounding(surface);
  bool allAgree = true;
  for (const Contender& contender : field.contenders)
  {
    const std::size_t checked = contender.tipsPerCall > 1 ? calls / 10 : calls;
    const double bound = 2.0 * rounding * contender.tipsPerCall;
    const std::vector<double> expected = expectedDistances(contender, field, checked);
    const std::vector<double> found = distances(contender, checked);
    std::size_t local = 0;
    std::size_t wrong = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < checked; ++i)
    {
      const double difference = std::abs(found[i] - expected[i]);
      largest = std::max(largest, difference);
      local += expected[i] > found[i] + bound ? 1 : 0;
      wrong += !(difference <= bound) ? 1 : 0;
    }
    std::printf("  %-22s %5zu calls, distances within %.1e mm (bound %.1e), local minima %zu%s\n",
      contender.name.c_str(), checked, largest, bound, local, wrong > 0 ? ": DISAGREES" : "");
    allAgree = allAgree && wrong == 0;
  }
  return allAgree;
}

/// A tick on a small separate body. It loads the code, but no data of another body, into the
/// caches.
struct Rehearsal
{
  Rehearsal()
    : surface(palpate::testing::bumpySphere(palpate::testing::bumpyCuts(1000)))
    , body(makePalpateBody(surface, bumpyResponses(surface)))
    , tick(makePalpateTick(*body))
  {
  }
  Surface surface;
  std::unique_ptr<ContactBody> body;
  std::unique_ptr<TimedMethod> tick;
};

/// Returns the rows of one body; no rows if the methods do not agree.
std::vector<TickRow> timeBody(
  const Options& options, double triangles, const Paths& paths, TickTimer& timer)
{
  const Rehearsal rehearsal;
  Surface surface = palpate::testing::bumpySphere(palpate::testing::bumpyCuts(triangles));
  if (options.shuffled)
  {
    surface = palpate::testing::shuffled(surface, 1);
  }
  std::printf("\n%zu triangles: same answers as palpate-point\n", surface.triangles.size());
  Field field;
  addPalpate(field, surface, paths);
  const double largest = *std::max_element(options.triangles.begin(), options.triangles.end());
  if (!options.own)
  {
    addCompact(field, surface, paths);
    if (triangles == largest && !options.shuffled)
    {
      addShuffled(field, palpate::testing::shuffled(surface, 1), paths);
    }
  }
  field.contenders.front().rehearsal = rehearsal.tick.get();
  field.leaders = field.contenders.size();
  if (!options.own)
  {
    addPeers(field, surface, paths);
  }
  if (!agree(field, surface, std::min(options.checkedCalls, paths.single.size())))
  {
    return {};
  }
  const std::vector<TickTimes> times = timer.run(field.contenders, field.leaders);
  std::vector<TickRow> rows;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const Contender& contender = field.contenders[i];
    rows.push_back({ contender.name, surface.triangles.size(), contender.buildSeconds,
      contender.megabytes, contender.tipsPerCall, times[i] });
  }
  printRows(rows, surface.triangles.size());
  return rows;
}

void printSetting(const Options& options, TickTimer& timer)
{
  const palpate::testing::CurvatureRange curvature = palpate::testing::bumpyCurvatures(100000);
  const ColdRead read = measureColdRead(timer.clock(), timer.flush());
  std::printf("Bumpy sphere, mean radius 100 mm: smallest convex radius of curvature %.1f mm, %s\n",
    1.0 / curvature.greatest, curvature.least < 0.0 ? "not convex" : "CONVEX");
  std::printf("Tip %.0f mm deep, %.1f mm per tick%s\n", Depth, Step,
    options.shuffled ? "; points and triangles shuffled" : "");
  std::printf("Clock: a reading costs %.0f ns, subtracted; it advances by %.1f ns\n",
    timer.clock().overhead(), timer.clock().step());
  std::printf(
    "Caches flushed by reading %zu MiB; one read then costs %.0f ns, in 4 KiB pages %.0f ns\n",
    timer.flush().bytes() >> 20, read.largePages, read.smallPages);
}

int run(const Options& options)
{
  const auto start = std::chrono::steady_clock::now();
  TickTimer timer;
  timer.hotCalls = options.hotCalls;
  timer.coldCalls = options.coldCalls;
  if (options.quick)
  {
    timer.hotSeconds = 0.2;
  }
  printSetting(options, timer);
  const Paths paths = makePaths(options);
  std::vector<TickRow> rows;
  for (const double triangles : options.triangles)
  {
    const std::vector<TickRow> more = timeBody(options, triangles, paths, timer);
    if (more.empty())
    {
      std::fprintf(stderr, "palpateTickBenchmark: the methods do not agree (see above)\n");
      return 1;
    }
    rows.insert(rows.end(), more.begin(), more.end());
  }
  printTargets(rows);
  const std::string csv = (std::filesystem::path(options.output) / "tick.csv").string();
  if (!writeTickCsv(csv, rows))
  {
    std::fprintf(stderr, "palpateTickBenchmark: cannot write '%s'\n", csv.c_str());
    return 1;
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  std::printf("\n%.0f s; results in %s\n", passed.count(), csv.c_str());
  return 0;
}
} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app{ "A tick of contact beside other ways to find a closest point.",
    "palpateTickBenchmark" };
  app.add_option("--triangles", options.triangles, "numbers of triangles, separated by commas")
    ->delimiter(',')
    ->check(CLI::Range(8.0, 2e7));
  app.add_option("--output", options.output, "folder for tick.csv")->check(CLI::ExistingDirectory);
  CLI::Option* const hot =
    app.add_option("--calls", options.hotCalls, "calls per method with hot caches, at most")
      ->check(CLI::Range(2000, 200000));
  CLI::Option* const cold =
    app.add_option("--cold-calls", options.coldCalls, "calls per method with cold caches")
      ->check(CLI::Range(1, 100000));
  app.add_flag("--shuffled", options.shuffled, "bodies with points and triangles in random order");
  app.add_flag("--own", options.own, "without other libraries, compact responses and random order");
  app.add_flag("--quick", options.quick, "few calls: all rows, but poor percentiles");
  CLI11_PARSE(app, argc, argv);
  if (options.quick)
  {
    options.hotCalls = hot->count() > 0 ? options.hotCalls : 10000;
    options.coldCalls = cold->count() > 0 ? options.coldCalls : 100;
  }

  // The methods that use VTK's threads need this back end.
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  return run(options);
}
