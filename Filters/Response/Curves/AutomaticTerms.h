// SPDX-License-Identifier: BSD-3-Clause
#ifndef AutomaticTerms_h
#define AutomaticTerms_h

#include "Laws/ResponseFiller.h"
#include "Response/BodyLaws.h"

#include "palpateResponseModule.h"

#include <functional>
#include <memory>
#include <string>

namespace palpate
{
class StrainCorrection;

/// The simplest law that keeps the forces of the requested law, and the reason as text.
struct AutomaticTerms
{
  LawTerms terms;
  BodyMaterial material;
  std::unique_ptr<StrainCorrection> strain = {}; ///< null if small strain was chosen without the
                                                 ///< correction
  std::string reason = {};
};

/// Makes the correction of a material by finite strain. Returns "" or an error message.
using StrainMaker = std::function<std::string(
  const BodyMaterial&, const StrainLaw&, std::unique_ptr<StrainCorrection>&)>;

/**
 * Removes terms from the law of `request` one by one (layers, curvature, finite strain), as long as
 * together they change the force by no more than request.terms.changeTolerance (TermEffect.h).
 * Finite strain is considered if it is requested, or if Neo-Hooke's tables have the tool. On input
 * `chosen` has the terms of the request. Collective: without a piece of the body, `shape` is not
 * used. Returns "" or an error message.
 */
PALPATERESPONSE_EXPORT std::string chooseTerms(const Ranks& ranks, vtkPolyData* body,
  const LawRequest& request, const SurfaceShape& shape, const StrainMaker& makeStrain,
  AutomaticTerms& chosen);

/// A change of the force as text: "0.8 %".
PALPATERESPONSE_EXPORT std::string percentOf(double change);

/// Name of the field array that stores the reason, `<name>Terms` (termsName), and its text on a
/// body; "" without the array (termsReason).
PALPATERESPONSE_EXPORT std::string termsName(const std::string& responseName);
PALPATERESPONSE_EXPORT std::string termsReason(vtkPolyData* body, const std::string& responseName);
} // namespace palpate

#endif
