// SPDX-License-Identifier: BSD-3-Clause
#include "TrialRuns.h"

#include "BlindTrial.h"
#include "ScenePath.h"
#include "SessionSettings.h"

#include "vtkDoubleArray.h"
#include "vtkHapticSession.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace palpate
{
namespace
{
/// Returns the path of the simulated hand, repeated `times` times.
vtkSmartPointer<vtkPolyData> repeated(vtkPolyData* path, std::size_t times)
{
  vtkDataArray* time = path->GetPointData()->GetArray("Time");
  const vtkIdType count = path->GetNumberOfPoints();
  double end = 0.0;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> when;
  when->SetName("Time");
  for (std::size_t k = 0; k < times; ++k)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      points->InsertNextPoint(path->GetPoint(i));
      when->InsertNextValue(end + time->GetTuple1(i));
    }
    // The stored last time is used, so that the times never decrease.
    end += time->GetTuple1(count - 1);
  }
  auto all = vtkSmartPointer<vtkPolyData>::New();
  all->SetPoints(points);
  all->GetPointData()->AddArray(when);
  return all;
}

/// Moves the simulated hand once along its path. Returns the largest force, N.
double pressOnce(vtkHapticSession* session, double seconds)
{
  double strongest = 0.0;
  const double end = session->GetTime() + seconds;
  while (session->GetTime() < end - 0.5 / session->GetRate())
  {
    session->Step(1.0 / session->GetRate());
    double force[3];
    session->GetForce(force);
    strongest = std::max(strongest, vtkMath::Norm(force));
  }
  return strongest;
}

/// Presses first X and then Y with the simulated hand.
void pressBoth(BlindTrial& trial, vtkHapticSession* session, double seconds)
{
  const double x = pressOnce(session, seconds);
  trial.switchOver();
  const double y = pressOnce(session, seconds);
  std::printf("X pushed back with up to %.4g N, Y with up to %.4g N\n", x, y);
}

/// Runs one trial. Sets `hasEnded` at the end of the input. `seconds` is the duration of each press
/// of the simulated hand; it is 0 if a person presses.
std::string ask(BlindTrial& trial, vtkHapticSession* session, double seconds, bool& hasEnded)
{
  const bool isSimulated = seconds > 0.0;
  trial.begin();
  std::printf("%s: %s\n", trial.title().c_str(), trial.question().c_str());
  if (isSimulated)
  {
    pressBoth(trial, session, seconds);
  }
  while (true)
  {
    std::printf(isSimulated ? "1: X   2: Y\n" : "1: X   2: Y   s: switch; now %s\n",
      trial.showsX() ? "X" : "Y");
    std::fflush(stdout);
    std::string line;
    if (!std::getline(std::cin, line))
    {
      hasEnded = true;
      return {};
    }
    if (line == "1" || line == "2")
    {
      return trial.answer(line == "1");
    }
    if (line == "s" && !isSimulated)
    {
      trial.switchOver();
    }
    else
    {
      std::printf("'%s' is not an answer\n", line.c_str());
    }
  }
}
} // namespace

std::string runTrialConsole(const ViewerOptions& options, const ViewerScene& scene)
{
  ResponseSet responses;
  BlindTrial trial;
  std::string error = prepareResponses(options, scene, responses);
  if (error.empty())
  {
    error = trial.prepare(options, scene, responses);
  }
  vtkNew<vtkPolyData> path;
  if (error.empty())
  {
    error = makePath(scene, path);
  }
  vtkNew<vtkHapticSession> session;
  if (error.empty())
  {
    session->SetBody(responses.body);
    session->GetDevice()->SetPath(repeated(path, 2 * trial.numberOfTrials()));
    session->SetRate(options.rate);
    session->GetRecorder()->RecordingOff();
    error = chooseDevice(options, responses, session);
    session->SetRealTime(!session->GetDevice()->IsSimulated());
  }
  if (error.empty())
  {
    placeDevice(scene, responses, session);
    error = startQuietly(session); // the start determines the force factor
  }
  if (error.empty())
  {
    error = trial.open(options, scene, responses, session);
  }
  const double seconds = session->GetDevice()->IsSimulated() && error.empty()
    ? path->GetPointData()->GetArray("Time")->GetRange()[1]
    : 0.0;
  bool hasEnded = false;
  while (error.empty() && !hasEnded && !trial.isOver())
  {
    error = ask(trial, session, seconds, hasEnded);
  }
  session->Stop();
  if (!error.empty())
  {
    return error;
  }
  if (hasEnded)
  {
    std::printf("ended before %s was answered\n", trial.title().c_str());
  }
  for (const std::string& line : trial.summary())
  {
    std::printf("%s\n", line.c_str());
  }
  return {};
}
} // namespace palpate
