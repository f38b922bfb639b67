// SPDX-License-Identifier: BSD-3-Clause
#include "ForceMap.h"

#include "MapColors.h"
#include "MapStage.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/JoinedText.h"
#include "Response/Curves/StoredError.h"
#include "ResponseSet.h"

#include "vtkCamera.h"
#include "vtkContactTool.h"
#include "vtkDataArray.h"
#include "vtkForceMap.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
constexpr double ZoomWithLegend = 0.65;

/// A summary of the forces at all points.
struct ForceSummary
{
  vtkIdType strongest = -1; ///< index of the point, away from the held part, with the largest
                            ///< force; -1 if there is none
  double largest = 0.0;     ///< force at this point, N
  double upper = 0.0;   ///< largest force at any point, N, which is the upper end of the colours
  double median = 0.0;  ///< N
  double least = 0.0;   ///< lower end of the colours, N; 2 % of the points have a smaller force
  double missing = 0.0; ///< fraction of the points without a force
};

/// Removes forces whose error has no bound, for example next to held points. Points without a force
/// have no colour and are not counted.
void removeUnbounded(vtkPolyData* mapped)
{
  vtkDataArray* force = mapped->GetPointData()->GetArray("ForceAtDepth");
  vtkDataArray* error = mapped->GetPointData()->GetArray("ErrorAtDepth");
  for (vtkIdType i = 0; error && i < force->GetNumberOfTuples(); ++i)
  {
    if (!(error->GetTuple1(i) < 1.0))
    {
      force->SetTuple1(i, std::numeric_limits<double>::quiet_NaN());
    }
  }
}

/// Returns the distance from the held part within which the support determines the force, mm. It is
/// two contact radii. Without this margin, a point next to the base would often have the largest
/// force.
double supportedDistance(const ViewerScene& scene)
{
  vtkNew<vtkContactTool> tool;
  tool->SetSpecification(scene.tools.front());
  return 2.0 * tool->GetContactRadius(scene.depth);
}

/// For each point, whether it is farther than `distance` (mm) from all held points. The result is
/// true for all points if the body has no array of held points, or if no point is farther.
std::vector<bool> awayFromHeld(vtkPolyData* mapped, double distance)
{
  const auto count = static_cast<std::size_t>(mapped->GetNumberOfPoints());
  vtkDataArray* fixed = mapped->GetPointData()->GetArray("Fixed");
  vtkNew<vtkPoints> held;
  for (vtkIdType i = 0; fixed && i < mapped->GetNumberOfPoints(); ++i)
  {
    if (fixed->GetTuple1(i) != 0.0)
    {
      held->InsertNextPoint(mapped->GetPoint(i));
    }
  }
  std::vector<bool> away(count, true);
  if (held->GetNumberOfPoints() == 0)
  {
    return away;
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(held);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(places);
  locator->BuildLocator();
  for (std::size_t i = 0; i < count; ++i)
  {
    double found = 0.0;
    away[i] = locator->FindClosestPointWithinRadius(
                distance, mapped->GetPoint(static_cast<vtkIdType>(i)), found) < 0;
  }
  const bool isAny = std::find(away.begin(), away.end(), true) != away.end();
  return isAny ? away : std::vector<bool>(count, true);
}

/// Summarises the forces. `away` marks the points among which the strongest one is searched.
/// `strongest` is -1 if no point has a force.
ForceSummary summarise(vtkPolyData* mapped, const std::vector<bool>& away)
{
  constexpr double LeastShare = 0.02;
  vtkDataArray* force = mapped->GetPointData()->GetArray("ForceAtDepth");
  ForceSummary summary;
  std::vector<double> known;
  for (vtkIdType i = 0; i < force->GetNumberOfTuples(); ++i)
  {
    const double value = force->GetTuple1(i);
    if (std::isfinite(value))
    {
      known.push_back(value);
      summary.upper = std::max(summary.upper, value);
      if (away[static_cast<std::size_t>(i)] && (summary.strongest < 0 || value > summary.largest))
      {
        summary.strongest = i;
        summary.largest = value;
      }
    }
  }
  summary.missing = 1.0 -
    static_cast<double>(known.size()) /
      static_cast<double>(std::max<vtkIdType>(force->GetNumberOfTuples(), 1));
  std::sort(known.begin(), known.end());
  if (!known.empty())
  {
    summary.median = known[known.size() / 2];
    summary.least = known[static_cast<std::size_t>(LeastShare * static_cast<double>(known.size()))];
  }
  return summary;
}

std::string describe(
  const ViewerScene& scene, vtkPolyData* mapped, const ForceSummary& summary, double distance)
{
  std::array<double, 3> at{};
  mapped->GetPoint(summary.strongest, at.data());
  vtkDataArray* error = mapped->GetPointData()->GetArray("ErrorAtDepth");
  const std::string off = error ? errorInWords(error->GetTuple1(summary.strongest)) : "";
  const std::string apart = mapped->GetPointData()->HasArray("Fixed")
    ? "  (without the places within " + shortly(distance) + " mm\n  of the held part)\n"
    : std::string();
  std::array<char, 600> text{};
  std::snprintf(text.data(), text.size(),
    "%s\n%s, %.2f mm deep\n \n"
    "largest force %.4g N%s\n  at %.1f, %.1f, %.1f mm\n"
    "%s"
    "median force %.4g N\n"
    "no force on %.1f %% of the points\n  (grey: held, beyond the curve,\n  or with an error "
    "without bound)",
    scene.title.c_str(), scene.tools.front().c_str(), scene.depth, summary.largest, off.c_str(),
    at[0], at[1], at[2], apart.c_str(), summary.median, 100.0 * summary.missing);
  return text.data();
}
} // namespace

std::string runForceMap(const ViewerOptions& options, const ViewerScene& scene)
{
  ResponseSet responses; // for the files of --save and --export
  std::string error = prepareFirstResponse(options, scene, responses);
  if (!error.empty())
  {
    return error;
  }
  vtkNew<vtkForceMap> map;
  map->SetInputData(scene.body);
  map->SetDepth(scene.depth);
  error = updateQuietly(map);
  if (!error.empty())
  {
    return error;
  }
  vtkPolyData* mapped = map->GetOutput();
  removeUnbounded(mapped);
  const double distance = supportedDistance(scene);
  const ForceSummary summary = summarise(mapped, awayFromHeld(mapped, distance));
  if (summary.strongest < 0)
  {
    return joined("no point of the body has a force at a depth of ", scene.depth,
      " mm: give a smaller --depth");
  }
  MapStage stage("Palpate: " + scene.title, options.window);
  vtkRenderer* renderer = stage.addRenderer({ 0.0, 0.0, 0.66, 1.0 });
  const std::array<double, 2> range = { std::min(summary.least, 0.999 * summary.upper),
    summary.upper };
  addColoredBody(mapped, makeMapColors(range, 1.0), "Force (N)\n ", "%.3g", renderer);
  const std::string words = describe(scene, mapped, summary, distance);
  stage.addWords(words, { 0.66, 0.0, 1.0, 1.0 });
  stage.lookFrom(mapped, scene.viewFrom, scene.up);
  // Zooms in, because the view is narrower than high and the legend covers a part of it.
  renderer->GetActiveCamera()->Zoom(ZoomWithLegend);
  std::printf("%s\n  material    %s\n  model       %s\n", words.c_str(), scene.tissues.c_str(),
    scene.modelReason.c_str());
  return stage.show(options);
}
} // namespace palpate
