// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainEnergy_h
#define palpate_StrainEnergy_h

#include "Mechanics/FiniteStrain/StrainLaw.h"
#include "Mechanics/PalpateExport.h"
#include "Strain/SecondOrder.h"

#include <array>

namespace palpate
{
/**
 * The isochoric strain energy of a material per undeformed volume, MPa, for an axisymmetric
 * deformation. The total energy is the sum of this energy and the volumetric energy K/2 (J-1)²,
 * which is projected in the elements (FiniteIndentation.h). μ = E/2(1+ν), K = E/3(1-2ν); at small
 * strain all models agree with Hooke's law.
 *
 * The energy is a function of the displacement gradient H = F-1. Therefore neither the energy nor
 * the stress of a small strain is computed as a difference of large numbers. Far from a contact,
 * where elements are very large, the rounding error of such a difference would exceed the result.
 */
class PALPATE_EXPORT StrainEnergy
{
public:
  /// The components ∂u_r/∂r, ∂u_r/∂z, ∂u_z/∂r, ∂u_z/∂z, u_r/r of the displacement gradient.
  template <class Number>
  using Gradient = std::array<Number, 5>;

  /// `parameter` is α of Ogden, or b of Demiray. For allowed values see checkStrainEnergy().
  StrainEnergy(StrainModel model, double shearModulus, double parameter = 0.0)
    : Model(model)
    , ShearModulus(shearModulus)
    , Parameter(parameter)
  {
  }

  bool isLinear() const noexcept { return this->Model == StrainModel::Linear; }

  /// Returns J - 1; for a linear material the trace of H. If the value is <= -1, the body is turned
  /// inside out.
  template <class Number>
  Number volumeChange(const Gradient<Number>& h) const;
  /// Returns the energy, for J > 0. `volumeChange` is volumeChange(h).
  template <class Number>
  Number isochoric(const Gradient<Number>& h, const Number& volumeChange) const;

private:
  StrainModel Model;
  double ShearModulus;
  double Parameter;
};
} // namespace palpate

#endif
