// SPDX-License-Identifier: BSD-3-Clause
// The cost of a body of a given size, from its pre-computation to a tick and a frame: a line "name
// value" per quantity on the output stream. One size per process, so that its memory is measured
// alone. The body is the bumpy sphere of the benchmarks; README.md states the timed steps.
#include "Response/BodyConversion.h"
#include "BumpySphere.h"
#include "DrawnBody.h"
#include "Response/FlatBodyConversion.h"
#include "Contact/FlatBodyFile.h"
#include "FrameScenes.h"
#include "ProcessMemory.h"
#include "TickTimes.h"
#include "Contact/ToolContact.h"

#include "vtkContactTool.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkResponseChoice.h"
#include "vtkSMPTools.h"
#include "vtkToolContactProbe.h"
#include "vtkToolContactResponse.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <CLI/CLI.hpp>

#include <malloc.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

namespace
{
using namespace palpate::benchmarks;
using palpate::ContactBody;
using palpate::Vector3;
using palpate::testing::windingDirection;
using palpate::testing::windingTip;
using Body = vtkSmartPointer<vtkPolyData>;

constexpr double Depth = 1.0; // mm, of the tip
constexpr double Step = 0.1;  // mm, from tick to tick
// 10 N at 1 mm, as in the benchmarks of the tick: F = 4/3 E* √R δ^1.5.
const char* const Tool = "paraboloid:5";
constexpr double PoissonRatio = 0.45;
const double ReducedModulus = 10.0 / (4.0 / 3.0 * std::sqrt(5.0));

void tell(const char* name, double value)
{
  std::printf("%s %.9g\n", name, value);
  std::fflush(stdout);
}

/// Resident memory after the return of freed memory to the system; bytes.
double memoryInUse()
{
  malloc_trim(0);
  return palpate::testing::residentMemory();
}

template <class Work>
double secondsOf(const Work& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The median of several passes. The number of passes keeps the total time about equal for every
/// size. With `once` there is a single pass.
class Passes
{
public:
  Passes(double points, bool once)
    : Count(once ? 1 : 2 * static_cast<std::size_t>(std::clamp(5e5 / points, 0.0, 7.0)) + 1)
  {
  }
  template <class Work>
  double medianSeconds(const Work& work) const
  {
    std::vector<double> seconds;
    for (std::size_t pass = 0; pass < this->Count; ++pass)
    {
      malloc_trim(0); // so that the next allocation gets new pages
      seconds.push_back(secondsOf(work));
    }
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(this->Count / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    return *middle;
  }

private:
  std::size_t Count;
};

double sizeOf(const std::string& file)
{
  struct stat found = {};
  return stat(file.c_str(), &found) == 0 ? static_cast<double>(found.st_size) : std::nan("");
}

/// Response of the tool; with `array`, on a layer with that thickness at each point.
Body respond(vtkPolyData* body, const char* array)
{
  vtkNew<vtkContactTool> tool;
  tool->SetSpecification(Tool);
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(tool);
  filter->SetYoungsModulus(ReducedModulus * (1.0 - PoissonRatio * PoissonRatio));
  filter->SetPoissonRatio(PoissonRatio);
  filter->CurvatureCorrectionOff(); // the reference is a flat surface
  filter->SetErrorTolerance(0.0);
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
  filter->Update();
  auto output = Body::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

/// Thickness of 6 to 20 mm, smooth over the body, with a few per cent of unevenness.
void addThickness(vtkPolyData* body)
{
  vtkNew<vtkFloatArray> thickness;
  thickness->SetName("Thickness");
  thickness->SetNumberOfTuples(body->GetNumberOfPoints());
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    const double wave = std::sin(0.05 * x[0] + 1.0) * std::cos(0.04 * x[1]) * std::cos(0.03 * x[2]);
    thickness->SetValue(
      i, static_cast<float>(13.0 + 6.5 * wave + 0.05 * static_cast<double>(i % 11)));
  }
  body->GetPointData()->AddArray(thickness);
}

void measureResponses(vtkPolyData* body, const Passes& passes)
{
  tell("response_s", passes.medianSeconds([&] { respond(body, ""); }));
  addThickness(body);
  Body layered;
  tell("layer_s",
    passes.medianSeconds(
      [&]
      {
        layered = nullptr;
        layered = respond(body, "Thickness");
      }));
  vtkNew<vtkResponseChoice> choice;
  choice->SetInputData(layered);
  tell("choice_s",
    passes.medianSeconds(
      [&]
      {
        choice->Modified();
        choice->Update();
      }));
  tell("choice_numbers", choice->GetNumbersPerPoint());
  body->GetPointData()->RemoveArray("Thickness");
}

/// Bytes of the response arrays per point.
double responseBytes(vtkPolyData* body)
{
  double bytes = 0.0;
  for (int i = 0; i < body->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = body->GetPointData()->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (name.rfind("Response", 0) == 0)
    {
      bytes += static_cast<double>(array->GetNumberOfValues()) * array->GetDataTypeSize();
    }
  }
  return bytes / static_cast<double>(body->GetNumberOfPoints());
}

void measureFiles(vtkPolyData* body, double points, const Passes& passes, const std::string& folder)
{
  const std::string vtp = folder + "/scale.vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary();
  writer->SetFileName(vtp.c_str());
  writer->SetInputData(body);
  tell("vtp_save_s", secondsOf([&] { writer->Write(); }));
  tell("vtp_bytes_per_vertex", sizeOf(vtp) / points);
  tell("vtp_load_s",
    secondsOf(
      [&]
      {
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(vtp.c_str());
        reader->Update();
      }));
  std::remove(vtp.c_str());

  const std::string flat = folder + "/scale.palpate";
  std::string error;
  tell("flat_save_s", secondsOf([&] { error = palpate::writeFlatBody(body, "Response", flat); }));
  tell("flat_bytes_per_vertex", sizeOf(flat) / points);
  tell("flat_load_s",
    passes.medianSeconds(
      [&]
      {
        palpate::FlatBodyFile file;
        error += file.open(flat);
      }));
  std::remove(flat.c_str());
  if (!error.empty())
  {
    std::fprintf(stderr, "palpateScale: %s\n", error.c_str());
  }
}

std::shared_ptr<const ContactBody> measureKernel(vtkPolyData* body, double points)
{
  const double before = memoryInUse();
  std::string error;
  std::shared_ptr<const ContactBody> kernel;
  tell("kernel_s", secondsOf([&] { kernel = palpate::makeContactBody(body, "Response", error); }));
  tell("kernel_bytes_per_vertex", (memoryInUse() - before) / points);
  if (!kernel)
  {
    std::fprintf(stderr, "palpateScale: %s\n", error.c_str());
    return nullptr;
  }
  tell("record_bytes_per_vertex", static_cast<double>(kernel->response.memory()) / points);
  return kernel;
}

/// Measures the force on a tip 1 mm below the smooth body. The tip is less deep below the facets at
/// that place.
void measureForces(const ContactBody& kernel)
{
  constexpr int Tips = 500;
  palpate::ToolContact contact(kernel, {});
  double error = 0.0;
  double lawError = 0.0;
  for (int i = 0; i < Tips; ++i)
  {
    contact.reset();
    const palpate::Contact felt = contact.update(windingTip(Depth, 37.0 * i));
    error += std::pow(felt.normalForce / 10.0 - 1.0, 2) / Tips; // 10 N at 1 mm
    const double law = 10.0 * std::pow(felt.deflection, 1.5);
    lawError = std::max(lawError, std::abs(felt.normalForce / law - 1.0));
  }
  tell("force_error", std::sqrt(error));
  tell("law_error", lawError);
}

void measureTicks(const ContactBody& kernel, bool quick)
{
  TickTimer timer;
  timer.hotCalls = quick ? 2000 : 100000;
  timer.coldCalls = quick ? 20 : 500;
  const std::vector<Vector3> tips =
    palpate::testing::windingTips(timer.hotCalls + TickTimer::UncountedCalls, Depth, Step);
  std::vector<Contender> contenders;
  contenders.push_back({ "palpate-tick", makePalpateTick(kernel), 0.0, 0.0, 1, &tips, nullptr });
  const std::vector<TickTimes> times = timer.run(contenders, 1);
  tell("hot_ns", times[0].hot.median);
  tell("hot_p99_ns", times[0].hot.p99);
  tell("cold_ns", times[0].cold.median);
  tell("cold_p99_ns", times[0].cold.p99);
}

void measureFrames(vtkPolyData* body, double points, FramePath path, const char* name)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const Vector3& tip : palpate::testing::windingTips(100, Depth, 1.0))
  {
    places->InsertNextPoint(tip.data());
  }
  vtkNew<vtkPolyData> tips;
  tips->SetPoints(places);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(0, body);
  probe->SetTipData(tips);
  probe->Update();
  const Body probed = probe->GetOutput();
  FrameScene scene(path, body, probed);
  std::vector<double> seconds;
  const int frames = points < 2e6 ? 31 : 9;
  for (int frame = -2; frame < frames; ++frame)
  {
    const double passed = scene.draw(frame + 2);
    if (frame >= 0)
    {
      seconds.push_back(passed);
    }
  }
  std::nth_element(seconds.begin(), seconds.begin() + frames / 2, seconds.end());
  tell(name, seconds[static_cast<std::size_t>(frames / 2)]);
}
} // namespace

int main(int argc, char* argv[])
{
  double wanted = 1e4;
  std::string folder = ".";
  bool frames = false;
  bool quick = false;
  CLI::App app{ "What a body of a given size costs.", "palpateScale" };
  app.add_option("--vertices", wanted, "of the body, about")->check(CLI::Range(100.0, 1e8));
  app.add_option("--folder", folder, "for files that are written, read and removed")
    ->check(CLI::ExistingDirectory);
  app.add_flag("--frames", frames, "also draw frames (needs a display)");
  app.add_flag("--quick", quick, "once each and few ticks: all numbers, but poor times");
  CLI11_PARSE(app, argc, argv);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));

  Body body = drawnBody(2.0 * wanted);
  const auto points = static_cast<double>(body->GetNumberOfPoints());
  const Passes passes(points, quick);
  tell("vertices", points);
  tell("triangles", static_cast<double>(body->GetNumberOfPolys()));
  measureResponses(body, passes);
  body = respond(body, "");
  tell("array_bytes_per_vertex", responseBytes(body));
  measureFiles(body, points, passes, folder);
  const std::shared_ptr<const ContactBody> kernel = measureKernel(body, points);
  if (!kernel)
  {
    return 1;
  }
  measureForces(*kernel);
  measureTicks(*kernel, quick);
  if (frames)
  {
    measureFrames(body, points, FramePath::Plain, "plain_s");
    measureFrames(body, points, FramePath::Shader, "frame_s");
  }
  tell("peak_bytes_per_vertex", palpate::testing::peakMemory() / points);
  return 0;
}
