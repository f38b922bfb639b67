// SPDX-License-Identifier: BSD-3-Clause
#include "ForceMap.h"

#include "MapColors.h"
#include "MapStage.h"
#include "Mechanics/JoinedText.h"
#include "Response/Curves/StoredError.h"
#include "ResponseSet.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkForceMap.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

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

/// The forces at all points, and a summary of them.
struct ForceSummary
{
  vtkIdType strongest = -1;
  double largest = 0.0; ///< N
  double median = 0.0;  ///< N
  double least = 0.0;   ///< the lower end of the colours: the force that 2 % of the points do not
                        ///< reach, N
  double missing = 0.0; ///< fraction of the points without a force
};

/// Removes the forces whose error has no bound, as next to held points, so that they neither have a
/// colour nor count.
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

/// Returns no strongest point if no point has a force.
ForceSummary summarise(vtkPolyData* mapped)
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
      if (summary.strongest < 0 || value > summary.largest)
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

std::string describe(const ViewerScene& scene, vtkPolyData* mapped, const ForceSummary& summary)
{
  std::array<double, 3> at{};
  mapped->GetPoint(summary.strongest, at.data());
  vtkDataArray* error = mapped->GetPointData()->GetArray("ErrorAtDepth");
  const std::string off = error ? errorInWords(error->GetTuple1(summary.strongest)) : "";
  std::array<char, 400> text{};
  std::snprintf(text.data(), text.size(),
    "%s\n%s, %.2f mm deep\n \n"
    "largest force %.4g N%s\n  at %.1f, %.1f, %.1f mm\n"
    "median force %.4g N\n"
    "no force on %.1f %% of the points\n  (grey: held, beyond the curve,\n  or with an error "
    "without bound)",
    scene.title.c_str(), scene.tools.front().c_str(), scene.depth, summary.largest, off.c_str(),
    at[0], at[1], at[2], summary.median, 100.0 * summary.missing);
  return text.data();
}
} // namespace

std::string runForceMap(const ViewerOptions& options, const ViewerScene& scene)
{
  ResponseSet responses; // writes the files of --save and --export
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
  const ForceSummary summary = summarise(mapped);
  if (summary.strongest < 0)
  {
    return joined("no point of the body has a force at a depth of ", scene.depth,
      " mm: give a smaller --depth");
  }
  MapStage stage("Palpate: " + scene.title, options.window);
  vtkRenderer* renderer = stage.addRenderer({ 0.0, 0.0, 0.66, 1.0 });
  const std::array<double, 2> range = { std::min(summary.least, 0.999 * summary.largest),
    summary.largest };
  addColoredBody(mapped, makeMapColors(range, 1.0), "Force (N)\n ", "%.3g", renderer);
  const std::string words = describe(scene, mapped, summary);
  stage.addWords(words, { 0.66, 0.0, 1.0, 1.0 });
  stage.lookFrom(mapped, scene.viewFrom, scene.up);
  // The view is narrower than high, and the legend takes a part of it.
  renderer->GetActiveCamera()->Zoom(ZoomWithLegend);
  std::printf("%s\n  material    %s\n  model       %s\n", words.c_str(), scene.tissues.c_str(),
    scene.modelReason.c_str());
  return stage.show(options);
}
} // namespace palpate
