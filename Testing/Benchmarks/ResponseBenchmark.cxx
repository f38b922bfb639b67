// SPDX-License-Identifier: BSD-3-Clause
// vtkToolContactResponse on two million points, into new memory each time, compared with the time
// to clear the same amount of new memory in the same run. The ratio cannot reach 1, because the
// filter also reads points, normals and triangles: `read_MB`.
#include "ProcessMemory.h"

#include "vtkCellArray.h"
#include "vtkContactTool.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkToolContactResponse.h"

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace
{
constexpr vtkIdType Side = 1415; // points along each side: 2 002 225
constexpr vtkIdType PointCount = Side * Side;
constexpr vtkIdType TriangleCount = 2 * (Side - 1) * (Side - 1);
constexpr std::size_t Samples = 8;

/// A wavy square with normals and arrays `E` (MPa), `C` (mm/N), `h` and `h2` (mm). Built once.
vtkPolyData* grid()
{
  static const vtkNew<vtkPolyData> body;
  if (body->GetNumberOfPoints() > 0)
  {
    return body;
  }
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(PointCount);
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(PointCount);
  vtkNew<vtkFloatArray> young;
  young->SetName("E");
  young->SetNumberOfTuples(PointCount);
  vtkNew<vtkFloatArray> compliance;
  compliance->SetName("C");
  compliance->SetNumberOfTuples(PointCount);
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName("h");
  thickness->SetNumberOfTuples(PointCount);
  vtkNew<vtkFloatArray> second;
  second->SetName("h2");
  second->SetNumberOfTuples(PointCount);
  vtkNew<vtkTypeInt64Array> corners;
  corners->SetNumberOfValues(3 * TriangleCount);
  vtkIdType next = 0;
  for (vtkIdType j = 0; j < Side; ++j)
  {
    for (vtkIdType i = 0; i < Side; ++i)
    {
      const vtkIdType id = j * Side + i;
      const double x = 0.1 * static_cast<double>(i);
      points->SetPoint(id, x, 0.1 * static_cast<double>(j), std::sin(0.1 * x));
      const double slope = 0.1 * std::cos(0.1 * x);
      const double length = std::hypot(1.0, slope);
      normals->SetTuple3(id, -slope / length, 0.0, 1.0 / length);
      young->SetValue(id, 0.1F + 0.001F * static_cast<float>(id % 101));
      compliance->SetValue(id, 0.01F * static_cast<float>(id % 11));
      thickness->SetValue(id, 2.0F + 0.001F * static_cast<float>(id % 9973));
      second->SetValue(id, 2.0F + 0.001F * static_cast<float>(id % 15991));
      if (i + 1 < Side && j + 1 < Side)
      {
        for (const vtkIdType corner : { id, id + 1, id + Side + 1, id, id + Side + 1, id + Side })
        {
          corners->SetValue(next++, corner);
        }
      }
    }
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, corners);
  body->SetPoints(points);
  body->SetPolys(triangles);
  body->GetPointData()->SetNormals(normals);
  body->GetPointData()->AddArray(young);
  body->GetPointData()->AddArray(compliance);
  body->GetPointData()->AddArray(thickness);
  body->GetPointData()->AddArray(second);
  return body;
}

template <class Work>
double secondsOf(const Work& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Sizes of the output arrays of the filter, bytes: forces, stiffnesses (Samples values each),
/// normal, range, validity, status, limit.
std::vector<std::size_t> outputSizes()
{
  const auto points = static_cast<std::size_t>(PointCount);
  return { 4 * Samples * points, 4 * Samples * points, 12 * points, 4 * points, 4 * points, points,
    points };
}

/// Returns freed memory to the system, so that the next allocation gets new pages.
void forgetFreedMemory()
{
  malloc_trim(0);
}

/// Measures the time to clear the same memory on one thread. The arrays are allocated one by one,
/// as in the filter.
double clearSeconds()
{
  forgetFreedMemory();
  std::vector<void*> blocks;
  const double seconds = secondsOf(
    [&]
    {
      for (const std::size_t size : outputSizes())
      {
        blocks.push_back(std::malloc(size));
        benchmark::DoNotOptimize(std::memset(blocks.back(), 1, size));
      }
    });
  for (void* block : blocks)
  {
    std::free(block);
  }
  return seconds;
}

/// The input array that the filter processes: its index and its name; an empty name means none.
struct Given
{
  int index = 0;
  const char* array = "";
  const char* tool = "sphere:5";
  bool stack = false; ///< adds a second layer below, with ten times the modulus and thickness `h2`
};

void response(benchmark::State& state, const Given& given)
{
  vtkPolyData* body = grid();
  vtkNew<vtkContactTool> tool;
  tool->SetSpecification(given.tool);
  double filterSeconds = 0.0;
  double clearing = 0.0;
  double peak = 0.0; // bytes, in addition to the memory in use before
  for (auto _ : state)
  {
    vtkNew<vtkToolContactResponse> filter;
    filter->SetInputData(body);
    filter->SetTool(tool);
    filter->CurvatureCorrectionOff();
    filter->SetErrorTolerance(0.0);
    filter->SetNumberOfSamples(static_cast<int>(Samples));
    filter->SetInputArrayToProcess(
      given.index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, given.array);
    if (given.stack)
    {
      filter->AddLayer(1.0, 10.0 * filter->GetYoungsModulus(), 0.4);
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "h2");
    }
    forgetFreedMemory();
    palpate::testing::resetPeakMemory();
    const double before = palpate::testing::residentMemory();
    const double seconds = secondsOf([&] { filter->Update(); });
    peak = std::max(peak, palpate::testing::peakMemory() - before);
    if (!filter->GetOutput()->GetPointData()->HasArray("ResponseForce"))
    {
      state.SkipWithError("no response");
    }
    filter->SetInputData(nullptr);
    filter->GetOutput()->Initialize();
    state.SetIterationTime(seconds);
    filterSeconds += seconds;
    clearing += clearSeconds();
  }
  double bytes = 0.0;
  for (const std::size_t size : outputSizes())
  {
    bytes += static_cast<double>(size);
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["points"] = static_cast<double>(PointCount);
  state.counters["written_MB"] = bytes / 1e6;
  state.counters["read_MB"] = static_cast<double>(24 * PointCount + 24 * TriangleCount) / 1e6;
  state.counters["memset_ms"] = 1e3 * clearing / runs;
  state.counters["ratio"] = filterSeconds / clearing;
  state.counters["peak_MiB"] = peak / 1048576.0;
}

void ResponseOfConstants(benchmark::State& state)
{
  response(state, {});
}
void ResponseOfModulusArray(benchmark::State& state)
{
  response(state, { 0, "E" });
}
void ResponseOfComplianceArray(benchmark::State& state)
{
  response(state, { 2, "C" });
}
/// A layer whose thickness differs at each point, 2 to 12 mm.
void ResponseOfThicknessArray(benchmark::State& state, const char* tool)
{
  response(state, { 1, "h", tool });
}
/// Two layers whose thicknesses differ at each point, 2 to 12 and 2 to 18 mm. To be compared with
/// one layer under the same tool.
void ResponseOfStack(benchmark::State& state, const char* tool)
{
  response(state, { 1, "h", tool, true });
}
} // namespace

BENCHMARK(ResponseOfConstants)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(1.0);
BENCHMARK(ResponseOfModulusArray)->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(1.0);
BENCHMARK(ResponseOfComplianceArray)->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK_CAPTURE(ResponseOfStack, sphere, "sphere:6.35")
  ->UseManualTime()
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1);
#define PALPATE_LAYER_BENCHMARK(name, tool)                                                        \
  BENCHMARK_CAPTURE(ResponseOfThicknessArray, name, tool)                                          \
    ->UseManualTime()                                                                              \
    ->Unit(benchmark::kMillisecond)                                                                \
    ->Iterations(1)
PALPATE_LAYER_BENCHMARK(flat, "flat:1.6");
PALPATE_LAYER_BENCHMARK(paraboloid, "paraboloid:6.35");
PALPATE_LAYER_BENCHMARK(sphere, "sphere:6.35");
PALPATE_LAYER_BENCHMARK(cone, "cone:60");
PALPATE_LAYER_BENCHMARK(blunted, "blunted:2,60");
PALPATE_LAYER_BENCHMARK(rounded, "rounded:2,1");
PALPATE_LAYER_BENCHMARK(power, "power:4,0.01");
