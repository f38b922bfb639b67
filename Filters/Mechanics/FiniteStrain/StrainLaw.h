// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainLaw_h
#define palpate_StrainLaw_h

#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// Models of a soft body: the strain energy as a function of the strain.
enum class StrainModel
{
  Linear,   ///< small strain
  NeoHooke, ///< W = μ/2 (Ī₁-3)
  /// One term of Ogden: W = 2μ/α² (Σ λ̄^α - 3). α = 2 is Neo-Hooke. A large α > 0 stiffens the body
  /// in tension, α < 0 in compression.
  Ogden,
  Demiray ///< W = μ/2b (exp(b (Ī₁-3)) - 1), as for skin and arteries
};

/// Returns a message that names the parameter of the model if it is out of its range, else "".
/// Ranges: α not 0 and |α| ≤ 50, 0 < b ≤ 50.
PALPATE_EXPORT std::string checkStrainEnergy(StrainModel model, double parameter);

/// The strain law of a body: a model and its parameter (α of Ogden, b of Demiray).
struct StrainLaw
{
  StrainModel model = StrainModel::Linear;
  double parameter = 0.0;
};

/// Returns the strain law of the model with the index `model`, with the parameter of that model.
inline StrainLaw strainLawOf(int model, double ogden, double demiray)
{
  const auto law = static_cast<StrainModel>(model);
  return { law, law == StrainModel::Ogden ? ogden : demiray };
}

/// Returns a description: "finite strain (Neo-Hooke)", "finite strain (Ogden, alpha = 9)"; "small
/// strain" for Linear.
PALPATE_EXPORT std::string describe(const StrainLaw& law);
} // namespace palpate

#endif
