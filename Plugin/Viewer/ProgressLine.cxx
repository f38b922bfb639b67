// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressLine.h"

#include "ResponseSet.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

#include <unistd.h>

#include <cstdio>

namespace palpate
{
namespace
{
constexpr std::chrono::milliseconds BetweenOverwrites{ 100 };
constexpr std::chrono::milliseconds BetweenLines{ 10000 };
} // namespace

ProgressLine::ProgressLine(const std::string& step)
  : Step(step)
  , IsTerminal(isatty(STDERR_FILENO) != 0)
  , Next(this->IsTerminal ? Clock::time_point::min() : Clock::now() + BetweenLines)
{
}

ProgressLine::~ProgressLine()
{
  if (this->IsShown && this->IsTerminal)
  {
    std::fputs("\r\033[K", stderr);
  }
}

bool ProgressLine::show(double done)
{
  const Clock::time_point now = Clock::now();
  if (now >= this->Next)
  {
    std::fprintf(stderr, this->IsTerminal ? "\rpalpate: %s: %2.0f %% " : "palpate: %s: %.0f %%\n",
      this->Step.c_str(), 100.0 * done);
    std::fflush(stderr);
    this->IsShown = true;
    this->Next = now + (this->IsTerminal ? BetweenOverwrites : BetweenLines);
  }
  return true;
}

std::string updateWithProgress(vtkAlgorithm* algorithm, const std::string& step)
{
  ProgressLine line(step);
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(&line);
  forward->SetCallback([](vtkObject* caller, unsigned long, void* data, void*)
    { static_cast<ProgressLine*>(data)->show(static_cast<vtkAlgorithm*>(caller)->GetProgress()); });
  const unsigned long tag = algorithm->AddObserver(vtkCommand::ProgressEvent, forward);
  const std::string fault = updateQuietly(algorithm);
  algorithm->RemoveObserver(tag);
  return fault;
}
} // namespace palpate
