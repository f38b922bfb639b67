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
/// Creates the finite-strain correction of a material. The result is null after an abort, and for
/// the linear model.
using StrainMaker =
  std::function<Checked<std::unique_ptr<StrainCorrection>>(const BodyMaterial&, const StrainLaw&)>;

/**
 * Chooses the simplest law that keeps the forces of a request, and states the reason as text. Terms
 * are left out one by one (LawTerm::need) as long as the omitted terms together change the force by
 * at most request.terms.changeTolerance (TermEffect.h). Finite strain is considered if the request
 * contains it, or if the neo-Hookean tables contain the tool.
 */
class AutomaticTerms
{
public:
  /// If a rank has no piece of the body, `shape` is not used. All arguments must outlive this
  /// object.
  AutomaticTerms(const Ranks& ranks, vtkPolyData* body, const LawRequest& request,
    const SurfaceShape& shape, BodyMaterial material, StrainMaker makeStrain);

  /// Calls LawTerm::need of all terms. Collective. Returns "" or an error message.
  std::string choose();
  /// Returns the reasons as text; "" if no term was considered.
  std::string reason() const;

  bool hasPiece() const { return this->pressed.points > 0; }
  /// Returns the relative change of the force between two laws, which is the largest value of all
  /// ranks.
  double change(const LawModel& whole, const LawModel& less) const;
  /// Returns an upper bound of the relative change of the force by finite strain.
  double bound(const LawModel& model) const;
  bool isNegligible(double change) const { return change <= this->RestOfTolerance; }
  void leaveOut(double change) { this->RestOfTolerance -= change; }
  void addReason(const std::string& words);

  const Ranks& ranks;
  vtkPolyData* body;
  const LawRequest& request;
  const PressedBody pressed;
  const StrainMaker makeStrain;
  // The chosen terms and material. Their initial values are those of the request.
  LawTerms terms;
  BodyMaterial material;
  /// Correction found during the choice; null if small strain was chosen.
  std::unique_ptr<StrainCorrection> strain;

private:
  double RestOfTolerance;
  std::string Reasons;
};

/// Returns a relative change of the force as text, for example "0.8 %".
PALPATERESPONSE_EXPORT std::string percentOf(double change);

/// Returns the reason that a response stores in its array Terms. Returns "" if the array is
/// missing.
PALPATERESPONSE_EXPORT std::string termsReason(vtkPolyData* body, const std::string& responseName);
} // namespace palpate

#endif
