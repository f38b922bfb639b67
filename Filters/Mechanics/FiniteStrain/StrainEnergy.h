// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainEnergy_h
#define palpate_StrainEnergy_h

#include "Mechanics/FiniteStrain/SecondOrder.h"
#include "Mechanics/PalpateExport.h"

#include <array>
#include <string>

namespace palpate
{
/// Models of the stress of a soft body over strain.
enum class StrainModel
{
  Linear,   ///< small strain
  NeoHooke, ///< W = μ/2 (Ī₁-3)
  Ogden, ///< one term: W = 2μ/α² (Σ λ̄^α - 3); α = 2 is Neo-Hooke; large α > 0 stiffens in tension,
         ///< α < 0 in compression
  Demiray ///< W = μ/2b (exp(b (Ī₁-3)) - 1), as for skin and arteries
};

/**
 * The isochoric strain energy of a material per undeformed volume, MPa, for a body of revolution;
 * with the volumetric K/2 (J-1)² (projected by the elements, see FiniteIndentation.h) it is the
 * whole energy. μ = E/2(1+ν), K = E/3(1-2ν): at small strain all are Hooke's law.
 *
 * Written in the displacement gradient H = F-1, so that neither the energy nor the stress of a
 * small strain is a difference of large numbers: far from a contact, where elements are huge, the
 * rounding error of such a difference would exceed the result.
 */
class PALPATE_EXPORT StrainEnergy
{
public:
  /// ∂u_r/∂r, ∂u_r/∂z, ∂u_z/∂r, ∂u_z/∂z, u_r/r.
  template <class Number>
  using Gradient = std::array<Number, 5>;

  /// `parameter`: α of Ogden, b of Demiray. For allowed values see checkStrainEnergy.
  StrainEnergy(StrainModel model, double shearModulus, double parameter = 0.0)
    : Model(model)
    , ShearModulus(shearModulus)
    , Parameter(parameter)
  {
  }

  bool isLinear() const noexcept { return this->Model == StrainModel::Linear; }

  /// J - 1; of a linear material the trace. At -1 and below the body has turned inside out.
  template <class Number>
  Number volumeChange(const Gradient<Number>& h) const;
  /// Where J > 0. `volumeChange` is that of h.
  template <class Number>
  Number isochoric(const Gradient<Number>& h, const Number& volumeChange) const;

private:
  StrainModel Model;
  double ShearModulus;
  double Parameter;
};

/// Which parameter of the model is out of its range, or "": α not 0 and |α| ≤ 50, 0 < b ≤ 50.
PALPATE_EXPORT std::string checkStrainEnergy(StrainModel model, double parameter);

/// How a body resists large strain, with the parameter of the model: α of Ogden, b of Demiray.
struct StrainLaw
{
  StrainModel model = StrainModel::Linear;
  double parameter = 0.0;
};

/// "finite strain (Neo-Hooke)", "finite strain (Ogden, alpha = 9)"; "small strain" of Linear.
PALPATE_EXPORT std::string describe(const StrainLaw& law);
} // namespace palpate

#endif
