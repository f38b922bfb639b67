// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenSession.h"

#include "ErrorCause.h"
#include "ForceTrust.h"
#include "LayerModel.h"
#include "ModelChoice.h"
#include "Pictures.h"
#include "Interaction/Display/MemoryText.h"
#include "Haptics/Devices/RecordedSetup.h"
#include "ResponseSet.h"
#include "ScenePath.h"
#include "Haptics/Servo/ServoStep.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "SessionSettings.h"
#include "ThicknessPicture.h"
#include "Haptics/Devices/TrajectoryFile.h"

#include "vtkDataArray.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace palpate
{
namespace
{
void progress(const char* what)
{
  std::fprintf(stderr, "palpate: %s\n", what);
}

/// Returns the peak resident memory of this process, MB; 0 if unknown.
double peakMemory()
{
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
  {
    if (line.rfind("VmHWM:", 0) == 0)
    {
      return std::stod(line.substr(6)) / 1024.0;
    }
  }
  return 0.0;
}

/// Returns the index of the tick for the pictures. The tick is at the fraction `share` of the
/// slide.
vtkIdType picturedTick(vtkPolyData* path, double share, double rate, vtkIdType ticks)
{
  // The points of the path are approach, press, slide ..., rest and lift; see vtkPressPath.
  vtkDataArray* time = path->GetPointData()->GetArray("Time");
  const double begin = time->GetTuple1(2);
  const double end = time->GetTuple1(time->GetNumberOfTuples() - 3);
  const auto tick = static_cast<vtkIdType>(std::lround((begin + share * (end - begin)) * rate));
  return std::clamp<vtkIdType>(tick, 0, ticks - 1);
}

/// Returns the tick with the largest force, or null without contact.
const Tick* peakOf(const std::vector<Tick>& ticks)
{
  const auto peak = std::max_element(ticks.begin(), ticks.end(),
    [](const Tick& a, const Tick& b) { return a.contact.force.norm() < b.contact.force.norm(); });
  return peak != ticks.end() && peak->contact.triangle >= 0 ? &*peak : nullptr;
}

/// Describes time and contact point of a tick, such as "2.471 s, -12.3, 40, 7.15 mm".
std::string momentInWords(const Tick& tick)
{
  const Eigen::Vector3d& place = tick.contact.contactPoint;
  std::array<char, 120> text{};
  const auto tenths = [](double length)
  { return std::round(10.0 * length) / 10.0 + 0.0; }; // the sum with 0.0 avoids "-0"
  std::snprintf(text.data(), text.size(), "%.3f s, %.1f, %.1f, %.1f mm", tick.time,
    tenths(place.x()), tenths(place.y()), tenths(place.z()));
  return text.data();
}

/// Returns a number as text with four significant digits, as in the rest of the summary.
std::string fourDigits(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// Describes the tick in the pictures, and the tick of the largest force. Returns "" without
/// contact.
std::string momentRemark(const std::vector<Tick>& ticks, vtkIdType tick)
{
  const Tick* peak = peakOf(ticks);
  if (!peak)
  {
    return {};
  }
  const Tick& shown = ticks[static_cast<std::size_t>(tick)];
  if (&shown == peak)
  {
    return "At the peak, " + momentInWords(shown);
  }
  std::array<char, 60> force{};
  std::snprintf(
    force.data(), force.size(), "peak %#.3g N at %.3f s", peak->contact.force.norm(), peak->time);
  return "At " + momentInWords(shown) + "; " + force.data();
}

/// Compares the setup of a replayed record at a time (s) with the setup of the session. Returns ""
/// without a replay.
std::string replayRemark(vtkHapticSession* session, double time = 0.0)
{
  return session->GetDevice()->IsReplay()
    ? replayInWords(session->GetDevice()->GetRecordedSetups(), time, session->GetSetup())
    : std::string();
}

/// Describes the times of the changes in a record, such as "; the record changes this at 1.5 s, 3
/// s". Returns "" if there are no changes.
std::string changesOf(const RecordedSetups& setups)
{
  std::string times;
  for (std::size_t i = 1; i < setups.all().size(); ++i)
  {
    times += joined(i > 1 ? ", " : "; the record changes this at ", setups.all()[i].time, " s");
  }
  return times;
}

void printSummary(const ViewerOptions& options, const ViewerScene& scene,
  const ResponseSet& responses, const ModelChoice& choice, vtkHapticSession* session,
  const std::string& stiffening, const std::string& pictured)
{
  vtkNew<vtkTable> statistics;
  session->GetRecorder()->GetStatistics(statistics);
  const auto value = [&](const char* column)
  { return statistics->GetValueByName(0, column).ToDouble(); };
  std::printf("\n%s\n", scene.title.c_str());
  std::array<double, 6> bounds{};
  responses.body->GetBounds(bounds.data());
  std::printf("  body        %lld vertices, %lld triangles, %.4g x %.4g x %.4g mm\n",
    static_cast<long long>(responses.body->GetNumberOfPoints()),
    static_cast<long long>(responses.body->GetNumberOfPolys()), bounds[1] - bounds[0],
    bounds[3] - bounds[2], bounds[5] - bounds[4]);
  std::printf("  material    %s\n", describeMaterial(scene).c_str());
  std::printf("  tools      ");
  for (const std::string& tool : scene.tools)
  {
    std::printf(" %s", tool.c_str());
  }
  std::printf("; the first one touches\n");
  std::printf("  model       %s%s\n", describeLaw(scene).c_str(), scene.modelReason.c_str());
  if (options.verbose && !choice.reason.empty())
  {
    std::printf("  choice      %s\n", choice.reason.c_str());
  }
  if (!stiffening.empty())
  {
    std::printf("  layer       in the pictures %s\n", stiffening.c_str());
  }
  std::printf("  session     %.0f ticks of 1/%g s in virtual time, %.0f in contact\n",
    value("Ticks"), session->GetRate(), value("TicksInContact"));
  const std::string replay = replayRemark(session);
  if (!replay.empty())
  {
    constexpr std::size_t key = 8; // length of "Replay: "
    std::printf("  replay      %s%s\n", replay.c_str() + key,
      changesOf(session->GetDevice()->GetRecordedSetups()).c_str());
  }
  const std::vector<Tick>& ticks = session->GetRecorder()->GetTicks();
  const Tick* peak = peakOf(ticks);
  std::printf("  peak        force %.4g N, deflection %.4g mm%s\n", value("PeakForce (N)"),
    peak ? peak->contact.deflection : 0.0, peak ? (", at " + momentInWords(*peak)).c_str() : "");
  if (!pictured.empty())
  {
    std::printf("  pictures    %s\n", pictured.c_str());
  }
  const std::string memory = memoryInWords(value("PeakForce (N)"), value("MemoryAtPeak (N)"));
  if (!memory.empty())
  {
    std::printf("  relaxation  %s\n", memory.c_str());
  }
  const FrictionSettings& friction = session->GetSettings()->GetKernel().friction;
  if (friction.coefficient != 0.0)
  {
    std::printf("  friction    %s; peak %.4g N\n", frictionInWords(friction).c_str(),
      value("PeakFriction (N)"));
  }
  const std::string trust = describeTrust(responses.body, ticks, scene.terms.errorTolerance,
    [&](const Tick& tick) { return causeOfError(scene, responses, tick); });
  if (!trust.empty())
  {
    std::printf("  error       %s\n", trust.c_str());
  }
  std::printf(
    "  time        responses %.0f ms for %zu tools, choice %.0f ms; per tick median %.0f ns, "
    "99 %% below %.0f ns\n",
    1e3 * responses.seconds, responses.tools.size(), 1e3 * choice.seconds, value("MedianTick (ns)"),
    value("Percentile99Tick (ns)"));
  std::printf("  memory      responses %.1f MB per tool, peak of the process %.0f MB\n",
    responses.bytesPerTool / 1e6, peakMemory());
  std::printf("  files       in %s\n", options.output.c_str());
}

std::string drawPictures(const ViewerScene& scene, const ResponseSet& responses,
  const PicturedMoment& moment, const std::string& folder)
{
  std::string error =
    drawContact(folder + "/deflection.png", folder + "/overview.png", scene, responses, moment);
  if (error.empty())
  {
    error = drawCurves(folder + "/curves.png", scene, responses, moment);
  }
  if (error.empty() && scene.sideBySide)
  {
    error = drawSideBySide(folder + "/tools.png", scene, responses, moment);
  }
  if (error.empty() && scene.layer.scanned)
  {
    error = drawThickness(folder + "/thickness.png", scene);
  }
  return error;
}
} // namespace

std::string runOffscreen(const ViewerOptions& options, const ViewerScene& scene)
{
  std::error_code failed;
  std::filesystem::create_directories(options.output, failed);
  if (failed)
  {
    return "cannot make folder '" + options.output + "': " + failed.message();
  }
  progress("attaching the responses");
  ResponseSet responses;
  std::string error = prepareFirstResponse(options, scene, responses);
  if (!error.empty())
  {
    return error;
  }
  ModelChoice choice;
  error = chooseModel(options, scene, responses, choice);
  if (!error.empty())
  {
    return error;
  }
  vtkNew<vtkPolyData> path;
  error = makePath(scene, path);
  if (!error.empty())
  {
    return error;
  }

  progress("pressing and sliding");
  vtkNew<vtkHapticSession> session;
  session->SetBody(choice.body);
  session->GetDevice()->SetPath(path);
  session->SetRate(options.rate);
  chooseContact(options, scene, session);
  error = openDevice(options, session);
  if (error.empty() && session->GetDevice()->IsPhysical())
  {
    error = "--device " + options.device + ": it cannot be used in virtual time; give --window";
  }
  if (error.empty())
  {
    error = startQuietly(session);
  }
  if (!error.empty())
  {
    return error;
  }
  session->Step(session->GetDevice()->GetPathDuration());
  session->Stop();
  const std::vector<Tick>& ticks = session->GetRecorder()->GetTicks();
  const RecordedSetups& setups = session->GetRecorder()->GetSetups();
  error = writeTrajectory(options.output + "/trajectory.csv", ticks, setups);
  if (error.empty() && !options.record.empty())
  {
    error = writeTrajectory(options.record, ticks, setups);
  }
  if (!error.empty())
  {
    return error;
  }

  vtkNew<vtkPolyData> recording;
  session->GetRecorder()->GetRecording(recording);
  PicturedMoment moment;
  moment.recording = recording;
  moment.tick = picturedTick(path, scene.pictureAt, options.rate, recording->GetNumberOfPoints());
  moment.largestForce = 1e-9; // N; the scale of the arrow must be positive even without contact
  for (const Tick& tick : ticks)
  {
    moment.largestForce = std::max(moment.largestForce, tick.contact.force.norm());
  }
  moment.remark = momentRemark(ticks, moment.tick);
  const std::string replay =
    replayRemark(session, ticks[static_cast<std::size_t>(moment.tick)].time);
  moment.remark += replay.empty() ? "" : "\n" + replay;
  if (options.pictures)
  {
    progress("drawing");
    error = addOtherResponses(options, scene, picturedPoints(responses.body, moment), responses);
    error = error.empty() ? drawPictures(scene, responses, moment, options.output) : error;
  }
  if (error.empty())
  {
    const std::string stiffening = describeStiffening(scene, responses,
      nearestCorner(responses.body, moment), scene.depth, options.maximumDeflection);
    printSummary(options, scene, responses, choice, session, stiffening,
      options.pictures && peakOf(ticks)
        ? joined("force ",
            fourDigits(ticks[static_cast<std::size_t>(moment.tick)].idealForce.norm()), " N, at ",
            momentInWords(ticks[static_cast<std::size_t>(moment.tick)]))
        : std::string());
  }
  return error;
}
} // namespace palpate
