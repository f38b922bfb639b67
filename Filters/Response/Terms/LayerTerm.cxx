// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/AutomaticTerms.h"
#include "Response/Curves/MaterialArrays.h"
#include "Response/ReplacedCurves.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
/// A body with fewer layers, and its name, which is part of the reason.
struct SimplerBody
{
  BodyMaterial::Constants constants;
  MaterialArrays arrays;
  const char* name;
};

/// Returns the bodies to try, the simplest first. Returns an empty list if `material` is a
/// half-space.
std::vector<SimplerBody> simplerBodies(const LawRequest& request, const BodyMaterial& material)
{
  std::vector<SimplerBody> simpler;
  if (!material.range().hasLayers())
  {
    return simpler;
  }
  SimplerBody body{ request.material, request.arrays, "a half-space" };
  const std::vector<StackLayer> deeper = std::exchange(body.constants.deeper, {});
  body.constants.halfSpace.reset();
  body.arrays[SecondArrayIndex] = {};
  SimplerBody halfSpace = body;
  halfSpace.constants.thickness = 0.0;
  halfSpace.arrays[ThicknessArrayIndex] = {};
  simpler.push_back(halfSpace);
  if (!request.material.isStack())
  {
    return simpler;
  }
  const bool isConstant =
    !request.arrays[ThicknessArrayIndex].array && !request.arrays[SecondArrayIndex].array;
  if (isConstant && !deeper.empty() && !request.material.halfSpace)
  {
    SimplerBody whole = body;
    for (const StackLayer& layer : deeper)
    {
      whole.constants.thickness += layer.thickness;
    }
    whole.name = "one layer as thick as all of them";
    simpler.push_back(whole);
  }
  const bool slips = deeper.empty() ? request.material.halfSpace->slips : deeper.front().slips;
  body.constants.base = slips ? LayerBase::Slip : LayerBase::Bonded;
  body.name = "the first layer on a rigid base";
  simpler.push_back(body);
  return simpler;
}

void addThickness(const BodyMaterial& material, const std::string& name, ResponseArray which,
  double ContactSpot::*thickness, vtkPolyData* output)
{
  const ContactSpots spots = material.spots();
  std::vector<float> values(static_cast<std::size_t>(output->GetNumberOfPoints()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(spots.at(i).*thickness);
  }
  addFloats(output, name, which, 1, values);
}

void attachStack(const BodyMaterial& material, const std::string& name, vtkPolyData* output)
{
  const LayerStack& stack = material.range().stack;
  vtkNew<vtkDoubleArray> layers;
  layers->SetName(arrayName(name, ResponseArray::LayerStack).c_str());
  layers->SetNumberOfComponents(4);
  const auto add = [&layers](const StackLayer& layer, double thickness)
  {
    layers->InsertNextTuple4(
      thickness, layer.youngsModulus, layer.poissonRatio, layer.slips ? 1.0 : 0.0);
  };
  const std::array<double, 2> thinnest = { material.range().layers.thinnest,
    material.range().second.thinnest };
  for (std::size_t i = 0; i < stack.layers.size(); ++i)
  {
    add(stack.layers[i], i < thinnest.size() ? thinnest[i] : stack.layers[i].thickness);
  }
  if (stack.hasHalfSpace)
  {
    add(stack.halfSpace, 0.0);
  }
  output->GetFieldData()->AddArray(layers);
  if (stack.layers.size() > 1)
  {
    addThickness(material, name, ResponseArray::SecondThickness, &ContactSpot::second, output);
  }
}

/// Layers below the surface. They belong to the material and change the curves. The arrays
/// LayerThickness, LayerBase, LayerStack and SecondThickness store the layers for the displacement
/// field.
class LayerTerm : public LawTerm
{
public:
  bool isAsked(const LawRequest& request) const override;
  std::string make(const TermBody& response, vtkPolyData* output) const override;
  /// Tries simpler bodies in this order: a half-space, one layer, the first layer.
  std::string need(AutomaticTerms& choice) const override;
};
} // namespace

bool LayerTerm::isAsked(const LawRequest& request) const
{
  return request.material.thickness != 0.0 || request.material.isStack() ||
    !request.arrays[ThicknessArrayIndex].name.empty() ||
    !request.arrays[SecondArrayIndex].name.empty();
}

std::string LayerTerm::make(const TermBody& response, vtkPolyData* output) const
{
  if (!response.material || !response.material->range().hasLayers())
  {
    return {};
  }
  const BodyMaterial& material = *response.material;
  const std::string& name = response.request.responseName;
  addThickness(material, name, ResponseArray::LayerThickness, &ContactSpot::thickness, output);
  vtkNew<vtkUnsignedCharArray> base;
  base->SetName(arrayName(name, ResponseArray::LayerBase).c_str());
  base->InsertNextValue(static_cast<unsigned char>(material.range().layers.base));
  output->GetFieldData()->AddArray(base);
  if (material.range().hasStack())
  {
    attachStack(material, name, output);
  }
  return {};
}

std::string LayerTerm::need(AutomaticTerms& choice) const
{
  const Ranks& ranks = choice.ranks;
  const bool curved = choice.request.terms.curvature;
  std::string nearest;
  for (const SimplerBody& simpler : simplerBodies(choice.request, choice.material))
  {
    BodyMaterial less(simpler.constants);
    const std::string fault = ranks.firstFault(
      choice.hasPiece() ? readMaterial(choice.body, simpler.arrays, less) : std::string());
    if (!fault.empty())
    {
      return fault;
    }
    agreeOnRange(ranks, choice.hasPiece(), less);
    const double change = choice.change({ choice.material, curved }, { less, curved });
    if (choice.isNegligible(change))
    {
      choice.leaveOut(change);
      choice.addReason(joined(simpler.name, " suffices: it is off by ", percentOf(change)));
      choice.material = std::move(less);
      return {};
    }
    nearest += joined(nearest.empty() ? "" : ", ", simpler.name, " by ", percentOf(change));
  }
  if (!nearest.empty())
  {
    choice.addReason(
      joined(choice.material.range().hasStack() ? "the stack of layers stays" : "the layer stays",
        ": the force would be off with ", nearest));
  }
  return {};
}

const LawTerm& layerTerm()
{
  static const LayerTerm term;
  return term;
}
} // namespace palpate
