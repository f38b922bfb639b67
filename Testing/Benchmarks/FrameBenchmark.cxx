// SPDX-License-Identifier: BSD-3-Clause
// The cost of the dent in a frame. The scene has a moving contact. Its body is drawn without a
// dent, with a dent in the vertex shader, and with a dent computed point by point. See README.md.
#include "BumpySphere.h"
#include "DrawnBody.h"
#include "FrameScenes.h"

#include "vtkContactTool.h"
#include "vtkToolContactProbe.h"
#include "vtkToolContactResponse.h"

#include "vtkPoints.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace palpate::benchmarks;
using palpate::Vector3;

constexpr double Depth = 1.0;  // mm
constexpr double Step = 1.0;   // mm from frame to frame
constexpr int WarmUp = 3;      // uncounted frames, for shaders and buffers
constexpr double Budget = 1.5; // s by which the total time of a path may exceed that of the first
constexpr std::size_t Contacts = 1000;

struct Options
{
  std::vector<double> triangles{ 20e3, 1e6 };
  int frames = 200;
  std::string output = ".";
  bool quick = false;
};

struct Row
{
  vtkIdType triangles;
  std::string path;
  std::vector<double> seconds{};
  double at(double share) const
  {
    std::vector<double> sorted = this->seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
};

vtkSmartPointer<vtkPolyData> withResponse(vtkPolyData* body)
{
  vtkNew<vtkContactTool> tool;
  tool->SetShapeToSphere();
  vtkNew<vtkToolContactResponse> response;
  response->SetInputData(body);
  response->SetTool(tool);
  response->CurvatureCorrectionOff();
  response->SetErrorTolerance(0.0);
  response->Update();
  return response->GetOutput();
}

vtkSmartPointer<vtkPolyData> contactsWith(vtkPolyData* body)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vector3& tip : palpate::testing::windingTips(Contacts, Depth, Step))
  {
    points->InsertNextPoint(tip.data());
  }
  vtkNew<vtkPolyData> tips;
  tips->SetPoints(points);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(0, body);
  probe->SetTipData(tips);
  probe->Update();
  return probe->GetOutput();
}

/// Returns one row per path. The paths alternate frame by frame, so that other work of the machine
/// affects all of them. A path that has become too slow (Budget) draws fewer frames.
std::vector<Row> runBody(double triangles, int frames)
{
  const auto body = withResponse(drawnBody(triangles));
  const auto probed = contactsWith(body);
  std::vector<std::unique_ptr<FrameScene>> scenes;
  std::vector<Row> rows;
  for (const FramePath path : { FramePath::Plain, FramePath::Shader, FramePath::Filter })
  {
    scenes.push_back(std::make_unique<FrameScene>(path, body, probed));
    rows.push_back({ body->GetNumberOfPolys(), nameOf(path) });
  }
  std::vector<double> spent(scenes.size(), 0.0);
  for (int frame = -WarmUp; frame < frames; ++frame)
  {
    for (std::size_t turn = 0; turn < scenes.size(); ++turn)
    {
      // Each path is equally often the first in a turn.
      const std::size_t i = (turn + static_cast<std::size_t>(frame + WarmUp)) % scenes.size();
      if (frame > 0 && spent[i] > spent[0] + Budget)
      {
        continue;
      }
      const double seconds = scenes[i]->draw(frame + WarmUp);
      if (frame >= 0)
      {
        rows[i].seconds.push_back(seconds);
        spent[i] += seconds;
      }
    }
  }
  return rows;
}

void printRow(const Row& row, const Row& plain)
{
  std::printf("%9lld %-8s %6zu %10.2f %10.2f %10.2f\n", static_cast<long long>(row.triangles),
    row.path.c_str(), row.seconds.size(), 1e3 * row.at(0.5), 1e3 * row.at(0.9),
    row.at(0.5) / plain.at(0.5));
  std::fflush(stdout);
}

bool writeCsv(const std::string& file, const std::vector<std::vector<Row>>& bodies)
{
  std::FILE* const out = std::fopen(file.c_str(), "w");
  if (out == nullptr)
  {
    return false;
  }
  std::fputs("triangles,path,frames,median_ms,p90_ms,ratio\n", out);
  for (const std::vector<Row>& rows : bodies)
  {
    for (const Row& row : rows)
    {
      std::fprintf(out, "%lld,%s,%zu,%.4f,%.4f,%.4f\n", static_cast<long long>(row.triangles),
        row.path.c_str(), row.seconds.size(), 1e3 * row.at(0.5), 1e3 * row.at(0.9),
        row.at(0.5) / rows.front().at(0.5));
    }
  }
  const bool failed = std::ferror(out) != 0;
  return std::fclose(out) == 0 && !failed;
}
} // namespace

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app{ "How long a frame takes, with and without a dent.", "palpateFrameBenchmark" };
  app.add_option("--triangles", options.triangles, "of the bodies, separated by commas")
    ->delimiter(',')
    ->check(CLI::Range(100.0, 1e7));
  app.add_option("--frames", options.frames, "per body and path, at most")
    ->check(CLI::Range(1, 100000));
  app.add_option("--output", options.output, "folder for frame.csv")->check(CLI::ExistingDirectory);
  app.add_flag("--quick", options.quick, "20 thousand triangles, few frames: all rows, poor times");
  CLI11_PARSE(app, argc, argv);
  if (options.quick)
  {
    options.triangles = { 20e3 };
    options.frames = 5;
  }
  std::printf("%9s %-8s %6s %10s %10s %10s\n", "triangles", "path", "frames", "median, ms",
    "p90, ms", "to plain");
  std::vector<std::vector<Row>> bodies;
  for (const double triangles : options.triangles)
  {
    bodies.push_back(runBody(triangles, options.frames));
    for (const Row& row : bodies.back())
    {
      printRow(row, bodies.back().front());
    }
  }
  const std::string csv = (std::filesystem::path(options.output) / "frame.csv").string();
  if (!writeCsv(csv, bodies))
  {
    std::fprintf(stderr, "palpateFrameBenchmark: cannot write '%s'\n", csv.c_str());
    return 1;
  }
  std::printf("\nresults in %s\n", csv.c_str());
  return 0;
}
