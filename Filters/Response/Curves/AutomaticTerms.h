// SPDX-License-Identifier: BSD-3-Clause
#ifndef AutomaticTerms_h
#define AutomaticTerms_h

#include "Laws/TermEffect.h"
#include "Mechanics/Checked.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Response/BodyLaws.h"

#include "palpateResponseModule.h"

#include <functional>
#include <memory>
#include <string>

namespace palpate
{
/// Makes the finite-strain correction of a material. The value is null after an abort, and for the
/// linear model.
using StrainMaker =
  std::function<Checked<std::unique_ptr<StrainCorrection>>(const BodyMaterial&, const StrainLaw&)>;

/**
 * Chooses the simplest law that keeps the forces of a request, and states the reason as text. Terms
 * are left out one by one (LawTerm::need) as long as their total change of the force is at most
 * request.terms.changeTolerance (TermEffect.h). Finite strain is considered if it is requested, or
 * if the tables of Neo-Hooke contain the tool.
 */
class AutomaticTerms
{
public:
  /// A rank without a piece of the body does not use `shape`. All arguments must outlive this
  /// object.
  AutomaticTerms(const Ranks& ranks, vtkPolyData* body, const LawRequest& request,
    const SurfaceShape& shape, BodyMaterial material, StrainMaker makeStrain);

  /// Calls LawTerm::need of all terms. Collective. Returns "" or an error message.
  std::string choose();
  /// The reasons as text, "" if no term was considered.
  std::string reason() const;

  bool hasPiece() const { return this->pressed.points > 0; }
  /// Relative change of the force between two laws; the largest value of all ranks.
  double change(const LawModel& whole, const LawModel& less) const;
  /// Upper bound of the relative change of the force by finite strain.
  double bound(const LawModel& model) const;
  bool isNegligible(double change) const { return change <= this->RestOfTolerance; }
  void leaveOut(double change) { this->RestOfTolerance -= change; }
  void addReason(const std::string& words);

  const Ranks& ranks;
  vtkPolyData* body;
  const LawRequest& request;
  const PressedBody pressed;
  const StrainMaker makeStrain;
  // The chosen terms and material. Initially those of the request.
  LawTerms terms;
  BodyMaterial material;
  /// Correction found during the choice; null if small strain was chosen.
  std::unique_ptr<StrainCorrection> strain;

private:
  double RestOfTolerance;
  std::string Reasons;
};

/// A change of the force as text: "0.8 %".
PALPATERESPONSE_EXPORT std::string percentOf(double change);

/// Returns the reason that a response stores in its array Terms; "" without the array.
PALPATERESPONSE_EXPORT std::string termsReason(vtkPolyData* body, const std::string& responseName);
} // namespace palpate

#endif
