// SPDX-License-Identifier: BSD-3-Clause
#include "LayerModel.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Layers/LayerContact.h"

#include "vtkDataArray.h"
#include "vtkLayerThickness.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <iomanip>
#include <memory>
#include <sstream>
#include <vector>

namespace palpate
{
namespace
{
const char* const Assumptions =
  "assumed: rigid base, the layer bonded to it and homogeneous, its thickness along the normal, "
  "small strain; a layer's force depends more on nu than a half-space's";

/// With so many decimals.
std::string rounded(double value, int decimals)
{
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(decimals) << value;
  return stream.str();
}

vtkDataArray* scannedThickness(const TouchScene& scene)
{
  return scene.layer.scanned ? scene.body->GetPointData()->GetArray("LayerThickness") : nullptr;
}
} // namespace

std::optional<double> scanValue(const ViewerOptions& options, const LayerChoice& ofScene)
{
  const bool other = options.voxel > 0.0 || !options.measured.empty(); // decides on what lies below
  const bool wanted = options.layer.value_or(other ? LayerChoice{} : ofScene).scanned;
  return wanted ? std::optional<double>(options.baseValue) : std::nullopt;
}

std::string chooseLayer(const ViewerOptions& options, TouchScene& scene)
{
  if (scene.stored || options.voxel > 0.0 || !options.measured.empty())
  {
    scene.layer = {};
    return {};
  }
  scene.layer = options.layer.value_or(scene.layer);
  if (scene.layer.scanned && !scannedThickness(scene))
  {
    return "--layer scan: " + (options.body.empty() ? "this scene" : options.body) +
      " is no scan in which the thickness of a layer could be measured";
  }
  if (scene.layer.scanned || scene.layer.thickness > 0.0)
  {
    scene.modelReason = Assumptions;
  }
  return {};
}

std::string describeLaw(const TouchScene& scene)
{
  if (scene.stored)
  {
    return {};
  }
  if (vtkDataArray* thickness = scannedThickness(scene))
  {
    std::vector<double> found;
    for (vtkIdType i = 0; i < thickness->GetNumberOfTuples(); ++i)
    {
      if (thickness->GetTuple1(i) > 0.0)
      {
        found.push_back(thickness->GetTuple1(i));
      }
    }
    if (found.empty())
    {
      return "elastic half-space at every vertex: the scan shows no bone; ";
    }
    std::sort(found.begin(), found.end());
    const double share =
      static_cast<double>(found.size()) / static_cast<double>(thickness->GetNumberOfTuples());
    vtkNew<vtkLayerThickness> settings;
    return joined("elastic layer on rigid bone at the ", rounded(100.0 * share, 0),
      " % of the vertices where the scan shows bone within ", settings->GetMaximumDepth(), " mm (",
      rounded(found.front(), 1), " to ", rounded(found.back(), 1), " mm thick, median ",
      rounded(found[found.size() / 2], 1), " mm), half-space at the others; ");
  }
  return scene.layer.thickness > 0.0
    ? joined("elastic layer of ", scene.layer.thickness, " mm on a rigid base at every vertex; ")
    : "elastic half-space at every vertex; ";
}

double thicknessAt(const TouchScene& scene, vtkIdType point)
{
  vtkDataArray* thickness = scannedThickness(scene);
  return thickness ? thickness->GetTuple1(point) : scene.layer.thickness;
}

std::string describeSpot(const TouchScene& scene, vtkIdType point)
{
  const double thickness = thicknessAt(scene, point);
  if (scene.layer.scanned)
  {
    return thickness > 0.0 ? joined(", here ", rounded(thickness, 1), " mm over bone")
                           : std::string(", here no bone: half-space");
  }
  return thickness > 0.0 ? joined(", a layer of ", thickness, " mm") : std::string();
}

std::string describeStiffening(
  const TouchScene& scene, const ResponseSet& responses, vtkIdType point, double depth, double deep)
{
  const double thickness = thicknessAt(scene, point);
  if (!(thickness > 0.0))
  {
    return {};
  }
  const auto kernel = std::make_shared<const LayerKernel>(scene.poissonsRatio, LayerBase::Bonded);
  std::string all = rounded(thickness, 1) + " mm thick; times the force on a half-space";
  for (std::size_t i = 0; i < responses.tools.size(); ++i)
  {
    const AxisymmetricTool& tool = *responses.tools[i]->GetKernel();
    const LayerContact layer(tool, kernel, thickness);
    const auto ratio = [&](double depthNow)
    { return layer.evaluate(depthNow, 1.0).force / tool.evaluate(depthNow, 1.0).force; };
    all += joined(i == 0 ? ": " : ", ", scene.tools[i], " ", rounded(ratio(depth), 2), " at ",
      depth, " mm, ", rounded(ratio(deep), 2), " at ", deep, " mm");
  }
  return all;
}
} // namespace palpate
