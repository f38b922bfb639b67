// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/AutomaticTerms.h"

#include "Laws/TermEffect.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "vtkContactTool.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
/// A simpler body and its name.
struct SimplerBody
{
  BodyMaterial::Constants constants;
  MaterialArrays arrays;
  const char* name;
};

constexpr std::size_t ThicknessArray = 1;
constexpr std::size_t SecondArray = 4;

/// The bodies to try, the simplest first. Empty for a half-space.
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
  body.arrays[SecondArray] = {};
  SimplerBody halfSpace = body;
  halfSpace.constants.thickness = 0.0;
  halfSpace.arrays[ThicknessArray] = {};
  simpler.push_back(halfSpace);
  if (!request.material.isStack())
  {
    return simpler;
  }
  const bool isConstant =
    !request.arrays[ThicknessArray].array && !request.arrays[SecondArray].array;
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

/// Removes terms while their changes are within the tolerance.
class TermChooser
{
public:
  TermChooser(const Ranks& ranks, const PressedBody& pressed, bool hasPiece, double tolerance)
    : All(ranks)
    , Pressed(pressed)
    , HasPiece(hasPiece)
    , RestOfTolerance(tolerance)
  {
  }

  double change(const LawModel& whole, const LawModel& less) const
  {
    return this->All.largest(this->HasPiece ? changeOfForce(this->Pressed, whole, less) : 0.0);
  }
  double bound(const LawModel& model) const
  {
    return this->All.largest(this->HasPiece ? boundOfStrain(this->Pressed, model) : 0.0);
  }
  bool isNegligible(double change) const { return change <= this->RestOfTolerance; }
  void leaveOut(double change) { this->RestOfTolerance -= change; }
  void addReason(const std::string& words)
  {
    this->Reasons += (this->Reasons.empty() ? "" : "; ") + words;
  }
  std::string reason() const
  {
    return this->Reasons.empty() ? this->Reasons
                                 : joined(this->Reasons, " (down to ", this->Pressed.range,
                                     " mm, at ", 100.0 * this->Pressed.share, " % of the points)");
  }

private:
  const Ranks& All;
  const PressedBody& Pressed;
  bool HasPiece;
  double RestOfTolerance;
  std::string Reasons;
};

/// Chooses the simplest body that keeps the force.
std::string chooseBody(const Ranks& ranks, vtkPolyData* body, const LawRequest& request,
  bool hasPiece, TermChooser& chooser, BodyMaterial& material)
{
  std::string nearest;
  for (const SimplerBody& simpler : simplerBodies(request, material))
  {
    BodyMaterial less(simpler.constants);
    const std::string fault =
      ranks.firstFault(hasPiece ? readMaterial(body, simpler.arrays, less) : std::string());
    if (!fault.empty())
    {
      return fault;
    }
    agreeOnRange(ranks, hasPiece, less);
    const double change =
      chooser.change({ material, request.terms.curvature }, { less, request.terms.curvature });
    if (chooser.isNegligible(change))
    {
      chooser.leaveOut(change);
      chooser.addReason(joined(simpler.name, " suffices: it is off by ", percentOf(change)));
      material = std::move(less);
      return {};
    }
    nearest += joined(nearest.empty() ? "" : ", ", simpler.name, " by ", percentOf(change));
  }
  if (!nearest.empty())
  {
    chooser.addReason(
      joined(material.range().hasStack() ? "the stack of layers stays" : "the layer stays",
        ": the force would be off with ", nearest));
  }
  return {};
}
/// Chooses whether the law includes finite strain. The choice may need to compute the correction
/// itself.
std::string chooseStrain(const LawRequest& request, const StrainMaker& makeStrain,
  TermChooser& chooser, AutomaticTerms& chosen)
{
  const BodyMaterial& material = chosen.material;
  const bool isAsked = request.terms.strain.model != StrainModel::Linear;
  const StrainLaw law = isAsked ? request.terms.strain : StrainLaw{ StrainModel::NeoHooke, 0.0 };
  const std::string name = describe(law);
  const bool curved = chosen.terms.curvature;
  const LawModel small{ material, curved, nullptr };
  const double bound = chooser.bound(small); // upper bound of the error stated without finite
                                             // strain
  if (law.model == StrainModel::NeoHooke)
  {
    if (chooser.isNegligible(bound))
    {
      chooser.leaveOut(bound);
      chosen.terms.strain = {};
      chooser.addReason(joined(
        "small strain suffices: ", name, " changes the force by at most ", percentOf(bound)));
      return {};
    }
    if (!isAsked &&
      !isStrainTabulated(
        *request.tool->GetKernel(), material.range().strainBodies(), request.deflection))
    {
      chooser.addReason(joined("small strain is kept, with an error of up to ", percentOf(bound),
        ": ", name, " is not tabulated for this tool and would have to be computed by the solver"));
      return {};
    }
  }
  const std::string fault = makeStrain(material, law, chosen.strain);
  if (!fault.empty() || !chosen.strain)
  {
    return fault;
  }
  const double change = chooser.change({ material, curved, chosen.strain.get() }, small);
  if (chooser.isNegligible(std::max(change, bound)))
  {
    chooser.leaveOut(change);
    chosen.terms.strain = {};
    chosen.strain.reset();
    chooser.addReason(
      joined("small strain suffices: ", name, " changes the force by ", percentOf(change)));
    return {};
  }
  chosen.terms.strain = law;
  chooser.addReason(joined(name, " is in the law: without it the force is off by ",
    percentOf(change), ", and states an error of up to ", percentOf(bound)));
  return {};
}

void chooseCurvature(TermChooser& chooser, AutomaticTerms& chosen)
{
  if (!chosen.terms.curvature)
  {
    return;
  }
  const double change = chooser.change({ chosen.material, true }, { chosen.material, false });
  chosen.terms.curvature = !chooser.isNegligible(change);
  if (chosen.terms.curvature)
  {
    chooser.addReason(
      "the body's curvature is in the law: without it the force is off by " + percentOf(change));
  }
  else
  {
    chooser.leaveOut(change);
    chooser.addReason(
      "the body counts as flat: its curvature changes the force by " + percentOf(change));
  }
}

/// Edges are kept if the body has any, since a contact can leave the body over an edge at any
/// depth.
void chooseEdges(const Ranks& ranks, const PressedBody& pressed, bool hasPiece,
  TermChooser& chooser, AutomaticTerms& chosen)
{
  if (!chosen.terms.edges || !pressed.shape.edge || chosen.terms.errorTolerance == 0.0)
  {
    return;
  }
  bool areNear = false;
  for (std::size_t i = 0; hasPiece && i < pressed.points && !areNear; ++i)
  {
    areNear = pressed.shape.edge(i).distance < NearEdge::Far;
  }
  chosen.terms.edges = ranks.any(areNear);
  chooser.addReason(chosen.terms.edges
      ? "sharp edges have an effect"
      : "no sharp edge is within reach of a contact: edges are left out");
}
} // namespace

std::string chooseTerms(const Ranks& ranks, vtkPolyData* body, const LawRequest& request,
  const SurfaceShape& shape, const StrainMaker& makeStrain, AutomaticTerms& chosen)
{
  const bool hasPiece = body->GetNumberOfPoints() > 0;
  const PressedBody pressed{ *request.tool->GetKernel(), request.deflection,
    static_cast<std::size_t>(body->GetNumberOfPoints()), shape };
  TermChooser chooser(ranks, pressed, hasPiece, request.terms.changeTolerance);
  std::string fault = chooseBody(ranks, body, request, hasPiece, chooser, chosen.material);
  if (fault.empty())
  {
    chooseCurvature(chooser, chosen);
    chooseEdges(ranks, pressed, hasPiece, chooser, chosen);
    fault = chooseStrain(request, makeStrain, chooser, chosen);
  }
  chosen.reason = chooser.reason();
  return fault;
}

std::string percentOf(double change)
{
  if (!std::isfinite(change))
  {
    return "all of it";
  }
  char words[32];
  std::snprintf(words, sizeof words, "%.2g %%", 100.0 * change);
  return words;
}

std::string termsName(const std::string& responseName)
{
  return responseName + "Terms";
}

std::string termsReason(vtkPolyData* body, const std::string& responseName)
{
  auto* text = vtkStringArray::SafeDownCast(
    body->GetFieldData()->GetAbstractArray(termsName(responseName).c_str()));
  return text && text->GetNumberOfValues() > 0 ? text->GetValue(0) : std::string();
}
} // namespace palpate
