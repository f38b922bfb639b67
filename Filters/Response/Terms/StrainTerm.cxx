// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Terms/LawTerm.h"

#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/AutomaticTerms.h"
#include "vtkContactTool.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
/// Finite strain. The term multiplies the curves by a StrainCorrection.
class StrainTerm : public LawTerm
{
public:
  bool isAsked(const LawRequest& request) const override
  {
    return request.terms.strain.model != StrainModel::Linear;
  }
  ResponseModel words(const TermBody& response) const override;
  /// Computes the correction if the choice of terms depends on it.
  std::string need(AutomaticTerms& choice) const override;
};
} // namespace

ResponseModel StrainTerm::words(const TermBody& response) const
{
  return { ", " + palpate::describe(response.request.terms.strain), FiniteStrainPart };
}

std::string StrainTerm::need(AutomaticTerms& choice) const
{
  const LawRequest& request = choice.request;
  const BodyMaterial& material = choice.material;
  const bool isInRequest = this->isAsked(request);
  const StrainLaw law =
    isInRequest ? request.terms.strain : StrainLaw{ StrainModel::NeoHooke, 0.0 };
  const std::string name = palpate::describe(law);
  const bool curved = choice.terms.curvature;
  const LawModel small{ material, curved, nullptr };
  const double bound = choice.bound(small); // upper bound of the error without finite strain
  if (law.model == StrainModel::NeoHooke)
  {
    if (choice.isNegligible(bound))
    {
      choice.leaveOut(bound);
      choice.terms.strain = {};
      choice.addReason(joined(
        "small strain suffices: ", name, " changes the force by at most ", percentOf(bound)));
      return {};
    }
    if (!isInRequest &&
      !isStrainTabulated(
        *request.tool->GetKernel(), material.range().strainBodies(), request.deflection))
    {
      choice.addReason(joined("small strain is kept, with an error of up to ", percentOf(bound),
        ": ", name, " is not tabulated for this tool and would have to be computed by the solver"));
      return {};
    }
  }
  auto made = choice.makeStrain(material, law);
  if (!made || !*made)
  {
    return made.fault();
  }
  choice.strain = std::move(*made);
  const double change = choice.change({ material, curved, choice.strain.get() }, small);
  if (choice.isNegligible(std::max(change, bound)))
  {
    choice.leaveOut(change);
    choice.terms.strain = {};
    choice.strain.reset();
    choice.addReason(
      joined("small strain suffices: ", name, " changes the force by ", percentOf(change)));
    return {};
  }
  choice.terms.strain = law;
  choice.addReason(joined(name, " is in the law: without it the force is off by ",
    percentOf(change), ", and states an error of up to ", percentOf(bound)));
  return {};
}

const LawTerm& strainTerm()
{
  static const StrainTerm term;
  return term;
}
} // namespace palpate
