// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonPictures.h"

#include "ViewerModules.h"
#include "ComparisonStage.h"
#include "PictureSize.h"
#include "Pictures.h"
#include "MapStage.h"
#include "ScenePath.h"
#include "Haptics/Servo/ServoStep.h"
#include "SessionSettings.h"
#include "Haptics/Devices/TrajectoryFile.h"

#include "vtkContactScene.h"
#include "vtkDataArray.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace palpate
{
namespace
{
void sayProgress(const char* what)
{
  std::fprintf(stderr, "palpate: %s\n", what);
}

/// The recorded motion on one body.
struct Press
{
  vtkSmartPointer<vtkPolyData> recording = vtkSmartPointer<vtkPolyData>::New();
  vtkIdType pressed = 0; ///< index of the last tick before the slide
};

std::string pressAndSlide(
  const ViewerOptions& options, const ComparedBody& body, const std::string& file, Press& press)
{
  vtkNew<vtkPolyData> path;
  std::string error = makePath(body.scene, path);
  if (!error.empty())
  {
    return error;
  }
  vtkNew<vtkHapticSession> session;
  session->SetBody(body.responses.body);
  session->GetDevice()->SetPath(path);
  session->SetRate(options.rate);
  chooseContact(options, body.scene, session);
  error = startQuietly(session);
  if (!error.empty())
  {
    return error;
  }
  session->Step(session->GetDevice()->GetPathDuration());
  session->Stop();
  session->GetRecorder()->GetRecording(press.recording);
  // The applied force is removed, because the simulated device would limit the force to 10 N, but
  // bodies are compared, not devices.
  press.recording->GetPointData()->RemoveArray("AppliedForce");
  // The first points of the path are approach, press and slide; see vtkPressPath.
  const double slide = path->GetPointData()->GetArray("Time")->GetTuple1(2);
  press.pressed = static_cast<vtkIdType>(std::lround(slide * options.rate));
  return writeTrajectory(
    file, session->GetRecorder()->GetTicks(), session->GetRecorder()->GetSetups());
}

std::string drawComparison(const std::string& file, const std::array<ComparedBody, 2>& bodies,
  const std::array<Press, 2>& presses)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0); // without multisampling, the pixels are the same on every machine
  window->SetSize(PictureWidth, PictureHeight);
  vtkNew<vtkBodyComparison> comparison;
  comparison->SetRenderWindow(window);
  setStage(comparison, bodies);
  if (!comparison->ShowTips(presses[0].recording, presses[1].recording, presses[0].pressed))
  {
    return "the bodies cannot be compared (see above)";
  }
  const ViewerScene& scene = bodies[0].scene;
  comparison->LookAtBodies(scene.viewFrom.data(), scene.up.data());
  printStatements(comparison, bodies);
  return writePicture(window, file);
}

/// Draws regime index, sensitivity and verdict of the first tool over both bodies, one row per
/// body.
std::string drawRegime(const std::string& file, const std::array<ComparedBody, 2>& bodies)
{
  MapStage stage("", false);
  std::array<vtkSmartPointer<vtkPolyData>, 2> judged;
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    std::string error;
    judged[i] =
      judgeBody(bodies[i].scene, bodies[i].responses.tools.front(), bodies[i].scene.body, error);
    if (!error.empty())
    {
      return error;
    }
  }
  const ViewerScene& scene = bodies[0].scene;
  std::array<char, 200> where{};
  std::snprintf(where.data(), where.size(), "%s, %.2f mm deep",
    bodies[0].responses.tools.front()->GetDescription().c_str(), scene.depth);
  for (int quantity = vtkRegimeMap::Index; quantity <= vtkRegimeMap::Verdict; ++quantity)
  {
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      const double left = 0.5 * static_cast<double>(i);
      const double top = 1.0 - quantity / 3.0;
      vtkRenderer* renderer =
        stage.addMap(judged[i], quantity, { left, top - 1.0 / 3.0, left + 0.5, top });
      addSupport(renderer, bodies[i].support);
      if (quantity == vtkRegimeMap::Index)
      {
        stage.addTitle(bodies[i].scene.title + "\n" + where.data());
      }
    }
  }
  stage.lookFrom(judged[1], scene.viewFrom, scene.up);
  return writePicture(stage.window(), file);
}
} // namespace

std::string runComparison(const ViewerOptions& options)
{
  std::error_code failed;
  std::filesystem::create_directories(options.output, failed);
  if (failed)
  {
    return "cannot make folder '" + options.output + "': " + failed.message();
  }
  sayProgress("finite elements of a strip and a block");
  std::array<ComparedBody, 2> bodies;
  std::string error;
  if (const SolidsModule* solids = solidsModule("--compare", error))
  {
    error = solids->compareBodies(options, bodies);
  }
  std::array<Press, 2> presses;
  const std::array<const char*, 2> names = { "/strip.csv", "/block.csv" };
  sayProgress("pressing and sliding");
  for (std::size_t i = 0; i < bodies.size() && error.empty(); ++i)
  {
    error = pressAndSlide(options, bodies[i], options.output + names[i], presses[i]);
  }
  sayProgress("drawing");
  if (error.empty())
  {
    error = drawComparison(options.output + "/comparison.png", bodies, presses);
  }
  if (error.empty())
  {
    error = drawRegime(options.output + "/regime.png", bodies);
  }
  if (error.empty())
  {
    std::printf("\n  files       in %s\n", options.output.c_str());
  }
  return error;
}
} // namespace palpate
