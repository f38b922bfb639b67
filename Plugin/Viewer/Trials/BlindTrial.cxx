// SPDX-License-Identifier: BSD-3-Clause
#include "BlindTrial.h"

#include "ScenePath.h"
#include "Trials/TrialScore.h"

#include "vtkDoubleArray.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkToolContactProbe.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <random>
#include <sstream>

namespace palpate
{
namespace
{
const char* const Question = "Which one pushes back more?";
const char* const LumpQuestion = "Under which one is the lump?";

/// Returns the force on a tip at rest without friction, N.
double forceAt(vtkPolyData* body, const std::string& response, const ContactSettings& contact,
  const std::array<double, 3>& tip)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(tip.data());
  vtkNew<vtkPolyData> tips;
  tips->SetPoints(points);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(0, body);
  probe->SetInputData(1, tips);
  probe->SetResponseName(response);
  probe->GetSettings()->SetKernel(contact);
  vtkDataArray* force = updateQuietly(probe).empty()
    ? probe->GetOutput()->GetPointData()->GetArray("NormalForce")
    : nullptr;
  return force ? force->GetTuple1(0) : 0.0;
}

std::string dateAndTime()
{
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  std::ostringstream text;
  text << std::put_time(&parts, "%Y-%m-%d %H:%M:%S");
  return text.str();
}
} // namespace

std::string BlindTrial::chooseResponse(const ViewerScene& scene, const TrialChoice& choice,
  double maximumDeflection, ResponseSet& responses)
{
  const ContactLaw own = lawOf(scene);
  const ContactLaw law = { choice.youngsModulus.value_or(own.youngsModulus),
    choice.poissonRatio.value_or(own.poissonRatio), choice.layer.value_or(own.layer) };
  const std::string& tool = choice.tool.empty() ? scene.tools.front() : choice.tool;
  if (choice.hasLump && !scene.nodules)
  {
    return "alternative '" + choice.name + "': this body has no lumps; give --scene phantom";
  }
  // Suffix of the response name for the body without nodules.
  const std::string behind = choice.hasLump.value_or(true) ? "" : "Without";
  if (law == own)
  {
    for (std::size_t i = 0; i < scene.tools.size(); ++i)
    {
      if (scene.tools[i] == tool)
      {
        this->ResponseNames.push_back(responses.names[i] + behind);
        return {};
      }
    }
  }
  if (scene.stored || scene.solid)
  {
    return "alternative '" + choice.name + "': the material of this body is not to be changed";
  }
  if (law.layer.isStack() && !choice.layer && (choice.youngsModulus || choice.poissonRatio))
  {
    return "alternative '" + choice.name + "': each of the layers has its own young and poisson";
  }
  const std::string error = addToolResponse(scene, tool, law, maximumDeflection, responses);
  this->ResponseNames.push_back(responses.names.back());
  return error;
}

std::string BlindTrial::prepare(
  const ViewerOptions& options, const ViewerScene& scene, ResponseSet& responses)
{
  this->Choices = options.trial;
  this->Head.seed = options.trialSeed.value_or(std::random_device()());
  this->Plan =
    planTrials(static_cast<int>(this->Choices.size()), options.trialRounds, this->Head.seed);
  for (TrialChoice& choice : this->Choices)
  {
    choice.contact.friction.poissonRatio = choice.poissonRatio.value_or(scene.poissonRatio);
    const std::string error =
      this->chooseResponse(scene, choice, options.maximumDeflection, responses);
    if (!error.empty())
    {
      return error;
    }
  }
  return {};
}

std::string BlindTrial::open(const ViewerOptions& options, const ViewerScene& scene,
  const ResponseSet& responses, vtkHapticSession* session)
{
  this->Session = session;
  const std::array<double, 3> pressed = firstSite(scene, responses.body).above(-scene.depth);
  for (std::size_t i = 0; i < this->Choices.size(); ++i)
  {
    const TrialChoice& choice = this->Choices[i];
    this->Head.alternatives.push_back(
      { choice.name, forceAt(responses.body, this->ResponseNames[i], choice.contact, pressed) });
  }
  // Lumps are hard. Therefore, if all alternatives have the same tool, the alternative with the
  // larger force has the lump.
  const bool asksForLump = std::all_of(this->Choices.begin(), this->Choices.end(),
    [this](const TrialChoice& choice)
    { return choice.hasLump && choice.tool == this->Choices.front().tool; });
  this->Head.question = !options.question.empty() ? options.question
    : asksForLump                                 ? LumpQuestion
                                                  : Question;
  this->Head.hasRightAnswer = options.question.empty();
  this->Head.forceFactor = session->GetForceFactor();
  this->Head.device = options.device;
  this->Head.started = dateAndTime();
  this->Record.head = this->Head;
  std::string path = options.trialLog;
  if (path.empty())
  {
    std::error_code ignored; // an error is reported when the log is opened
    std::filesystem::create_directories(options.output, ignored);
    path = options.output + "/trial.csv";
  }
  return this->Log.open(path, this->Head);
}

std::string BlindTrial::title() const
{
  return "trial " + std::to_string(this->Current + 1) + " of " + std::to_string(this->Plan.size());
}

void BlindTrial::apply(std::size_t alternative)
{
  this->Session->SetResponseName(this->ResponseNames[alternative]);
  this->Session->GetSettings()->SetKernel(this->Choices[alternative].contact);
  this->Session->ApplyChanges();
}

void BlindTrial::show(bool x)
{
  const Trial& trial = this->Plan[this->Current];
  this->apply(static_cast<std::size_t>(x ? trial.x : trial.y));
  this->ShowsX = x;
}

void BlindTrial::begin()
{
  this->show(true);
  this->Switches = 0;
  this->BeginTime = std::chrono::steady_clock::now();
}

void BlindTrial::switchOver()
{
  this->show(!this->ShowsX);
  ++this->Switches;
}

std::string BlindTrial::answer(bool choseX)
{
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - this->BeginTime;
  const TrialAnswer given{ this->Plan[this->Current], choseX, taken.count(), this->Switches };
  this->Record.answers.push_back(given);
  ++this->Current;
  return this->Log.append(given);
}

std::vector<std::string> BlindTrial::summary() const
{
  return describeScore(this->Record.head, scoreTrials(this->Record));
}
} // namespace palpate
