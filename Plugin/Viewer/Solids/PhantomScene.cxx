// SPDX-License-Identifier: BSD-3-Clause
// A block of soft tissue with nine hard nodules under its skin, to be found by palpation. The whole
// block is solved by finite elements with and without the nodules. It is solved once, and the
// results are cached.
#include "ViewerScene.h"

#include "BodyCache.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "PhantomBody.h"
#include "ProgressLine.h"
#include "ResponseSet.h"
#include "SolvedCache.h"

#include "vtkContactTool.h"
#include "vtkNew.h"
#include "vtkNoduleDetectability.h"

#include <chrono>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr double UsualDepth = 0.8; // depth of the press if the options give none, mm
// Distance of source points, mm; half the distance between most nodules.
constexpr double SourceSpacing = 1.0;
// Distance of source points without nodules, mm; half the distance from a wall.
constexpr double SourceSpacingWithout = 15.0;

/// Returns the cache key, which contains all input of the solved phantom.
std::string phantomKey(const ViewerOptions& options, const ViewerScene& scene)
{
  return joined(PhantomRevision, solvedKey(options, scene), '|',
    shortestDecimals(options.depth.value_or(UsualDepth)));
}

/// Returns the names of the arrays of a solved phantom.
std::vector<std::string> arraysOf(std::size_t tools)
{
  std::vector<std::string> arrays = { "ForceChange" };
  for (std::size_t i = 0; i < tools; ++i)
  {
    const std::string name = responseName(i);
    arrays.insert(arrays.end(), { name + "Force", name + "WithoutForce" });
  }
  return arrays;
}

std::string solvePhantom(const ViewerOptions& options, ViewerScene& scene)
{
  const auto begin = std::chrono::steady_clock::now();
  std::fprintf(stderr, "palpate: solving the phantom: once, a minute or two\n");
  vtkNew<vtkNoduleDetectability> detectability;
  detectability->SetInputData(makePhantomGrid(scene.youngsModulus, scene.poissonRatio));
  vtkNew<vtkContactTool> tool;
  if (!tool->SetSpecification(scene.tools.front()))
  {
    return "tool '" + scene.tools.front() + "' is not known";
  }
  detectability->SetTool(tool);
  for (std::size_t i = 1; i < scene.tools.size(); ++i)
  {
    detectability->AddMoreTool(scene.tools[i]);
  }
  detectability->SetMaximumDeflection(options.maximumDeflection);
  detectability->SetPressDepth(options.depth.value_or(UsualDepth));
  detectability->SetErrorTolerance(options.terms.errorTolerance);
  detectability->SetSourceSpacing(SourceSpacing);
  detectability->SetSourceSpacingWithout(SourceSpacingWithout);
  detectability->StoreWithoutOn();
  const std::string error = updateWithProgress(detectability, "the phantom is solved");
  if (!error.empty())
  {
    return error;
  }
  scene.body = detectability->GetOutput();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  scene.notes.push_back(joined("phantom solved for ", detectability->GetNumberOfSolutions(),
    " points of ", scene.body->GetNumberOfPoints(), ", about ",
    static_cast<int>(detectability->GetMemoryEstimate()), " MiB, in ",
    static_cast<int>(taken.count() + 0.5), " s"));
  return {};
}

/// Returns the name of an option that is not permitted for a scene with its own body, or "" if
/// there is none.
std::string refusedOption(const ViewerOptions& options)
{
  const char* option = options.voxel > 0.0 ? "--voxel"
    : !options.measured.empty()            ? "--measured"
    : options.layer                        ? "--layer and --layers"
    : options.strainGiven                  ? "--strain"
    : options.relaxation.count > 0         ? "--relax"
                                           : nullptr;
  return option ? joined("--scene phantom is solved by finite elements at small strain: ", option,
                    " cannot change it")
                : std::string();
}
} // namespace

std::string makePhantomScene(const ViewerOptions& options, ViewerScene& scene)
{
  std::string error = refusedOption(options);
  if (!error.empty())
  {
    return error;
  }
  scene.title = "Phantom with nine nodules";
  scene.youngsModulus = options.youngsModulus.value_or(0.1);
  scene.poissonRatio = options.poissonRatio.value_or(0.45);
  scene.materialSource = "assumed: a soft silicone rubber";
  scene.tools = options.tools.empty() ? std::vector<std::string>{ "sphere:1.6" } : options.tools;
  scene.stored = true;
  scene.nodules = true;
  const std::string file = cachePlace("phantom", phantomKey(options, scene), ".vtp");
  scene.body = readSolved(file, arraysOf(scene.tools.size()));
  if (scene.body)
  {
    scene.notes.push_back("phantom taken from the cache " + file);
  }
  else
  {
    error = solvePhantom(options, scene);
    if (!error.empty())
    {
      return error;
    }
    const std::string fault = keepSolved(scene.body, file);
    if (!fault.empty())
    {
      scene.notes.push_back("cache not used: " + fault);
    }
  }
  scene.modelReason = joined("finite elements of the whole; hard nodules, ", NoduleHardness,
    " times as stiff, of 1.5, 3 and 5 mm, which begin 1, 2 and 3 mm under the skin, in a bonded "
    "box");
  scene.marks = outlineNodules();
  scene.marksInWords = "Black circles: nodules under the skin, seen from above";
  scene.depth = UsualDepth;
  // The path starts above the nodule of 3 mm radius whose top is 2 mm deep. It ends above the
  // nodule with the same radius whose top is 1 mm deep.
  scene.center = { 0.0, 0.0, -20.0 };
  scene.directions = { { -2.0, 0.0, 20.0 }, { -2.0, -16.0, 20.0 } };
  scene.pictureAt = 0.0;
  scene.viewFrom = { 0.1, -0.6, 1.0 };
  return {};
}
} // namespace palpate
