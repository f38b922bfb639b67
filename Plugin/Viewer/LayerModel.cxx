// SPDX-License-Identifier: BSD-3-Clause
#include "LayerModel.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Layers/LayerContact.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLayerThickness.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iomanip>
#include <memory>
#include <sstream>
#include <vector>

namespace palpate
{
namespace
{
const char* const StackAssumptions = "assumed: layers bonded to each other unless stated, each "
                                     "homogeneous, thickness along the normal";

const char* const Assumptions =
  "assumed: rigid base, the layer bonded to it and homogeneous, its thickness along the normal; "
  "a layer's force depends more on nu than a half-space's";

/// Returns a number as text with `decimals` decimals.
std::string rounded(double value, int decimals)
{
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(decimals) << value;
  return stream.str();
}

/// Returns the array with the total thickness of all layers from a scan. Returns null if the
/// thickness is not scanned.
vtkDataArray* scannedThickness(const ViewerScene& scene)
{
  return scene.layer.scanned ? scene.body->GetPointData()->GetArray("LayerThickness") : nullptr;
}
/// Divides the thickness of the soft tissue in the scan between the two layers of a stack. Adds the
/// arrays LayerThickness0 and LayerThickness1, each with its error. Where the scan shows no bone,
/// bone is assumed at the maximum depth of the search. The layer with a given thickness gets at
/// most half of the tissue's thickness.
void splitTissue(ViewerScene& scene)
{
  vtkDataArray* tissue = scannedThickness(scene);
  vtkNew<vtkLayerThickness> settings;
  const std::size_t other = 1 - scene.layer.scannedLayer;
  const double given = scene.layer.stack.layers[other].thickness;
  const auto body = vtkSmartPointer<vtkPolyData>::New();
  body->ShallowCopy(scene.body);
  const auto addArray = [&](std::size_t layer, const char* ending)
  {
    const auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(joined("LayerThickness", layer, ending).c_str());
    array->SetNumberOfTuples(tissue->GetNumberOfTuples());
    body->GetPointData()->AddArray(array);
    return array;
  };
  const std::array<vtkSmartPointer<vtkFloatArray>, 2> parts = { addArray(0, ""), addArray(1, "") };
  const std::array<vtkSmartPointer<vtkFloatArray>, 2> errors = { addArray(0, "Error"),
    addArray(1, "Error") };
  vtkDataArray* error = scene.body->GetPointData()->GetArray("LayerThicknessError");
  const auto split = [&](double whole)
  {
    std::array<double, 2> layers{};
    layers[other] = std::min(given, 0.5 * whole);
    layers[scene.layer.scannedLayer] = whole - layers[other];
    return layers;
  };
  for (vtkIdType p = 0; p < tissue->GetNumberOfTuples(); ++p)
  {
    const double found = tissue->GetTuple1(p);
    const double whole = found > 0.0 ? found : settings->GetMaximumDepth();
    const std::array<double, 2> layers = split(whole);
    const std::array<double, 2> thinnest =
      split(whole / (1.0 + whole * (error ? error->GetTuple1(p) : 0.0)));
    for (std::size_t i = 0; i < layers.size(); ++i)
    {
      parts[i]->SetValue(p, static_cast<float>(layers[i]));
      errors[i]->SetValue(p, static_cast<float>(1.0 / thinnest[i] - 1.0 / layers[i]));
    }
  }
  scene.body = body;
}

/// Returns the layers under a point.
LayerStack stackAt(const ViewerScene& scene, vtkIdType point)
{
  LayerStack stack = scene.layer.stack;
  for (std::size_t i = 0; scene.layer.scanned && i < stack.layers.size(); ++i)
  {
    const std::string name = "LayerThickness" + std::to_string(i);
    stack.layers[i].thickness =
      scene.body->GetPointData()->GetArray(name.c_str())->GetTuple1(point);
  }
  return stack;
}

/// Statistics of a scanned thickness.
struct Tissue
{
  std::vector<double> found; ///< thicknesses at the vertices with bone, ascending, mm
  double share = 0.0;        ///< number of vertices with bone, percent of all vertices
};
Tissue tissueOf(vtkDataArray* thickness)
{
  Tissue tissue;
  for (vtkIdType i = 0; i < thickness->GetNumberOfTuples(); ++i)
  {
    if (thickness->GetTuple1(i) > 0.0)
    {
      tissue.found.push_back(thickness->GetTuple1(i));
    }
  }
  std::sort(tissue.found.begin(), tissue.found.end());
  tissue.share = 100.0 * static_cast<double>(tissue.found.size()) /
    static_cast<double>(thickness->GetNumberOfTuples());
  return tissue;
}

std::string describeStack(const ViewerScene& scene)
{
  const LayerStack& stack = scene.layer.stack;
  std::string text = stack.layers.size() == 1 ? "elastic layer: " : "elastic layers from the top: ";
  for (std::size_t i = 0; i < stack.layers.size(); ++i)
  {
    const StackLayer& layer = stack.layers[i];
    const bool isScanned = scene.layer.scanned && i == scene.layer.scannedLayer;
    text += joined(i > 0 ? layer.slips ? "; slipping, " : "; " : "",
      isScanned ? std::string("the rest of the soft tissue") : joined(layer.thickness, " mm"),
      " of ", layer.youngsModulus, " MPa, nu ", layer.poissonRatio);
  }
  if (stack.hasHalfSpace)
  {
    return joined(text, stack.halfSpace.slips ? "; slipping on" : "; on", " a half-space of ",
      stack.halfSpace.youngsModulus, " MPa, nu ", stack.halfSpace.poissonRatio, "; ");
  }
  text += stack.base == LayerBase::Slip ? "; slipping on a rigid base" : "; bonded to a rigid base";
  if (!scene.layer.scanned)
  {
    return text + "; ";
  }
  const Tissue tissue = tissueOf(scannedThickness(scene));
  vtkNew<vtkLayerThickness> settings;
  const std::string depth =
    joined(", assumed at the others to lie ", settings->GetMaximumDepth(), " mm deep; ");
  return text + ", bone, found at " + rounded(tissue.share, 0) + " % of the vertices" +
    (tissue.found.empty() ? std::string()
                          : " below " + rounded(tissue.found.front(), 1) + " to " +
          rounded(tissue.found.back(), 1) + " mm of soft tissue, median " +
          rounded(tissue.found[tissue.found.size() / 2], 1) + " mm") +
    depth;
}

/// Returns the thickness of the layer under a point of the body, mm. Returns 0 for a half-space.
double thicknessAt(const ViewerScene& scene, vtkIdType point)
{
  vtkDataArray* thickness = scannedThickness(scene);
  return thickness ? thickness->GetTuple1(point) : scene.layer.thickness;
}
} // namespace

std::optional<double> scanValue(const ViewerOptions& options, const LayerChoice& ofScene)
{
  const bool other =
    // These options define the layers by themselves.
    options.voxel > 0.0 || options.solid || !options.measured.empty();
  const bool wanted = options.layer.value_or(other ? LayerChoice{} : ofScene).scanned;
  return wanted ? std::optional<double>(options.baseValue) : std::nullopt;
}

std::string chooseLayer(const ViewerOptions& options, ViewerScene& scene)
{
  if (scene.stored || options.voxel > 0.0 || options.solid || !options.measured.empty())
  {
    scene.layer = {};
    return {};
  }
  scene.layer = options.layer.value_or(scene.layer);
  if (scene.layer.scanned && !scannedThickness(scene))
  {
    return (scene.layer.isStack() ? "--layers scan: " : "--layer scan: ") +
      (options.body.empty() ? "this scene" : options.body) +
      " is no scan in which the thickness of a layer could be measured";
  }
  if (scene.layer.isStack())
  {
    scene.modelReason = StackAssumptions;
    if (scene.layer.scanned)
    {
      splitTissue(scene);
    }
  }
  else if (scene.layer.scanned || scene.layer.thickness > 0.0)
  {
    scene.modelReason = Assumptions;
  }
  return {};
}

std::string layerSource(const LayerChoice& layer)
{
  return layer.usual
    ? "moduli of the order that dermis and hypodermis show by indentation in vivo, Pailler-Mattei, "
      "Bec and Zahouani 2008, uncertain: in its plane skin is far stiffer; skin 1.5 mm thick, "
      "within the 0.8 to 2.0 mm of dermis in a face, Chopra et al. 2015; Poisson's ratios assumed; "
      "muscle is not distinguished from fat"
    : "given on the command line";
}

std::string describeMaterial(const ViewerScene& scene)
{
  if (!scene.tissues.empty())
  {
    return scene.tissues;
  }
  return scene.layer.isStack()
    ? "of each layer its own (" + scene.materialSource + ")"
    : joined("E = ", scene.youngsModulus, " MPa, nu = ", scene.poissonRatio, " (",
        scene.materialSource, ")");
}

std::string describeLaw(const ViewerScene& scene)
{
  if (scene.stored)
  {
    return {};
  }
  if (scene.layer.isStack())
  {
    return describeStack(scene);
  }
  if (vtkDataArray* thickness = scannedThickness(scene))
  {
    const Tissue tissue = tissueOf(thickness);
    const std::vector<double>& found = tissue.found;
    if (found.empty())
    {
      return "elastic half-space at every vertex: the scan shows no bone; ";
    }
    vtkNew<vtkLayerThickness> settings;
    return joined("elastic layer on rigid bone at the ", rounded(tissue.share, 0),
      " % of the vertices where the scan shows bone within ", settings->GetMaximumDepth(), " mm (",
      rounded(found.front(), 1), " to ", rounded(found.back(), 1), " mm thick, median ",
      rounded(found[found.size() / 2], 1), " mm), half-space at the others; ");
  }
  return scene.layer.thickness > 0.0
    ? joined("elastic layer of ", scene.layer.thickness, " mm on a rigid base at every vertex; ")
    : "elastic half-space at every vertex; ";
}

std::string describeSpot(const ViewerScene& scene, vtkIdType point)
{
  if (scene.layer.isStack())
  {
    const LayerStack stack = stackAt(scene, point);
    std::string text = scene.layer.scanned ? ", here layers of " : ", layers of ";
    for (std::size_t i = 0; i < stack.layers.size(); ++i)
    {
      text += (i > 0 ? " + " : "") + rounded(stack.layers[i].thickness, 1);
    }
    return text + " mm";
  }
  const double thickness = thicknessAt(scene, point);
  if (scene.layer.scanned)
  {
    return thickness > 0.0 ? joined(", here ", rounded(thickness, 1), " mm over bone")
                           : std::string(", here no bone: half-space");
  }
  return thickness > 0.0 ? joined(", a layer of ", thickness, " mm") : std::string();
}

std::string describeStiffening(const ViewerScene& scene, const ResponseSet& responses,
  vtkIdType point, double depth, double deep)
{
  const bool isStack = scene.layer.isStack();
  const LayerStack stack = isStack ? stackAt(scene, point) : LayerStack();
  const double thickness = isStack ? stack.layers.front().thickness : thicknessAt(scene, point);
  if (!(thickness > 0.0))
  {
    return {};
  }
  const auto kernel = isStack
    ? std::make_shared<const LayerKernel>(stack)
    : std::make_shared<const LayerKernel>(scene.poissonRatio, LayerBase::Bonded);
  std::string all = isStack
    ? describeSpot(scene, point).substr(2) + "; times the force on a half-space of the first"
    : rounded(thickness, 1) + " mm thick; times the force on a half-space";
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
