// SPDX-License-Identifier: BSD-3-Clause
#include "RegimeMap.h"

#include "DetectabilityMap.h"
#include "ForceMap.h"
#include "LayerModel.h"
#include "MapStage.h"
#include "ResponseSet.h"

#include "vtkContactTool.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRegimeMap.h"
#include "vtkTriangle.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
/// Fractions of the surface, from 0 to 1, with each verdict of vtkContactRegime, and without a
/// stable contact.
struct Shares
{
  std::array<double, 3> verdict{};
  double none = 0.0;
};

/// Measures the fractions by area. A third of each triangle's area is assigned to each corner of
/// the triangle.
Shares measureShares(vtkPolyData* judged)
{
  vtkDataArray* index = judged->GetPointData()->GetArray("RegimeIndex");
  vtkDataArray* verdict = judged->GetPointData()->GetArray("RegimeVerdict");
  Shares shares;
  double all = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < judged->GetNumberOfCells(); ++cell)
  {
    judged->GetCellPoints(cell, corners);
    std::array<Direction, 3> x{};
    for (vtkIdType k = 0; k < 3; ++k)
    {
      judged->GetPoint(corners->GetId(k), x[static_cast<std::size_t>(k)].data());
    }
    const double third = vtkTriangle::TriangleArea(x[0].data(), x[1].data(), x[2].data()) / 3.0;
    all += 3.0 * third;
    for (vtkIdType k = 0; k < 3; ++k)
    {
      const vtkIdType id = corners->GetId(k);
      const bool stable = std::isfinite(index->GetTuple1(id));
      (stable ? shares.verdict[static_cast<std::size_t>(verdict->GetTuple1(id))] : shares.none) +=
        third;
    }
  }
  for (double& share : shares.verdict)
  {
    share /= all;
  }
  shares.none /= all;
  return shares;
}

/// Returns the range of a point array as text, such as "-0.82 to 0.01".
std::string rangeOf(vtkPolyData* judged, const char* name)
{
  std::array<double, 2> range{};
  judged->GetPointData()->GetArray(name)->GetFiniteRange(range.data());
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.2f to %.2f", range[0], range[1]);
  return text.data();
}

std::string describe(const ViewerScene& scene, vtkContactTool* tool, vtkPolyData* judged)
{
  const Shares shares = measureShares(judged);
  std::array<char, 800> text{};
  std::snprintf(text.data(), text.size(),
    "%s\n%s, %.2f mm deep\n \n"
    "The shape of the tool matters on %.1f %% of the surface\n"
    "It matters a little (mixed) on %.1f %%\n"
    "A point force suffices on %.1f %%\n"
    "No stable contact on %.1f %%\n \n"
    "Regime index (lambda): %s\nTool sensitivity: %s\n \n"
    "lambda: share of the depth that is global; 0: local;\nbelow 0: stiffened by a near base\n"
    "sensitivity: dlnF/dln(size of the tool)",
    scene.title.c_str(), tool->GetDescription().c_str(), scene.depth, 100.0 * shares.verdict[0],
    100.0 * shares.verdict[1], 100.0 * shares.verdict[2], 100.0 * shares.none,
    rangeOf(judged, "RegimeIndex").c_str(), rangeOf(judged, "ToolSensitivity").c_str());
  return text.data();
}

} // namespace

std::string runRegimeMap(const ViewerOptions& options, const ViewerScene& scene)
{
  if (scene.nodules)
  {
    return runDetectabilityMap(options, scene);
  }
  if (!scene.tissues.empty())
  {
    return runForceMap(options, scene);
  }
  if (scene.stored)
  {
    return options.body +
      ": brings its response, but not the material that a map is made of; give "
      "--tool, --young and --poisson";
  }
  vtkNew<vtkContactTool> tool;
  tool->SetSpecification(scene.tools.front());
  std::string error;
  const vtkSmartPointer<vtkPolyData> judged = judgeBody(scene, tool, scene.body, error);
  if (!error.empty())
  {
    return error;
  }
  MapStage stage("Palpate: " + scene.title, options.window);
  const std::array<std::array<double, 4>, 3> places = { { { 0.0, 0.5, 0.5, 1.0 },
    { 0.5, 0.5, 1.0, 1.0 }, { 0.0, 0.0, 0.5, 0.5 } } };
  for (int quantity = vtkRegimeMap::Index; quantity <= vtkRegimeMap::Verdict; ++quantity)
  {
    stage.addMap(judged, quantity, places[static_cast<std::size_t>(quantity)]);
  }
  const std::string words = describe(scene, tool, judged);
  stage.addWords(words, { 0.5, 0.0, 1.0, 0.5 });
  stage.lookFrom(judged, scene.viewFrom, scene.up);
  std::printf("%s\n  material    %s\n  model       %s%s\n", words.c_str(),
    describeMaterial(scene).c_str(), describeLaw(scene).c_str(), scene.modelReason.c_str());
  return stage.show(options);
}
} // namespace palpate
