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
/// Makes the correction of a material by finite strain. The value is null after an abort, and for
/// the linear model.
using StrainMaker =
  std::function<Checked<std::unique_ptr<StrainCorrection>>(const BodyMaterial&, const StrainLaw&)>;

/**
 * The simplest law that keeps the forces of a request, and the reason as text. Terms are left out
 * one by one (LawTerm::need), as long as together they change the force by no more than
 * request.terms.changeTolerance (TermEffect.h). Finite strain is considered if it is requested, or
 * if Neo-Hooke's tables have the tool.
 */
class AutomaticTerms
{
public:
  /// `shape` is not used without a piece of the body. All arguments must outlive this.
  AutomaticTerms(const Ranks& ranks, vtkPolyData* body, const LawRequest& request,
    const SurfaceShape& shape, BodyMaterial material, StrainMaker makeStrain);

  /// Asks all terms. Collective. Returns "" or an error message.
  std::string choose();
  /// The reasons as text, "" if no term was considered.
  std::string reason() const;

  bool hasPiece() const { return this->pressed.points > 0; }
  /// The change of the force between two laws, relative; the largest of all ranks.
  double change(const LawModel& whole, const LawModel& less) const;
  /// A bound of the change by finite strain.
  double bound(const LawModel& model) const;
  bool isNegligible(double change) const { return change <= this->RestOfTolerance; }
  void leaveOut(double change) { this->RestOfTolerance -= change; }
  void addReason(const std::string& words);

  const Ranks& ranks;
  vtkPolyData* body;
  const LawRequest& request;
  const PressedBody pressed;
  const StrainMaker makeStrain;
  // The choice; at first as requested.
  LawTerms terms;
  BodyMaterial material;
  std::unique_ptr<StrainCorrection> strain; ///< null if small strain was chosen without it

private:
  double RestOfTolerance;
  std::string Reasons;
};

/// A change of the force as text: "0.8 %".
PALPATERESPONSE_EXPORT std::string percentOf(double change);

/// The reason that the array Terms of a response stores; "" without the array.
PALPATERESPONSE_EXPORT std::string termsReason(vtkPolyData* body, const std::string& responseName);
} // namespace palpate

#endif
