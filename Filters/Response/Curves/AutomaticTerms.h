// SPDX-License-Identifier: BSD-3-Clause
#ifndef AutomaticTerms_h
#define AutomaticTerms_h

#include "Laws/ResponseFiller.h"
#include "Response/BodyLaws.h"

#include <functional>
#include <memory>
#include <string>

namespace palpate
{
class StrainCorrection;

/// The least law that keeps the forces of what was asked for, and why in words.
struct AutomaticTerms
{
  LawTerms terms;
  BodyMaterial material;
  std::unique_ptr<StrainCorrection> strain = {}; ///< where it had to be made already
  std::string reason = {};
};

/// Makes the correction of a material by finite strain. Returns what is wrong, or "".
using StrainMaker = std::function<std::string(
  const BodyMaterial&, const StrainLaw&, std::unique_ptr<StrainCorrection>&)>;

/**
 * Takes terms out of the law of `request` one by one (layers, curvature, finite strain), as long as
 * what has been left out changes the force by no more than request.terms.changeTolerance in sum
 * (TermEffect.h). Finite strain is considered where it is asked for, and where Neo-Hooke's tables
 * have the tool. `chosen` begins as what the request asks for. Collective: without a piece of the
 * body, `shape` is not asked. Returns what is wrong, or "".
 */
std::string chooseTerms(const Ranks& ranks, vtkPolyData* body, const LawRequest& request,
  const SurfaceShape& shape, const StrainMaker& makeStrain, AutomaticTerms& chosen);

/// A change of the force in words: "0.8 %".
std::string percentOf(double change);

/// The field array that keeps the reason, `<name>Terms`, and what it says on a body; "" without it.
std::string termsName(const std::string& responseName);
std::string termsReason(vtkPolyData* body, const std::string& responseName);
} // namespace palpate

#endif
