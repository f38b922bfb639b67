// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/StrainLaw.h"

#include "Mechanics/JoinedText.h"

#include <cmath>

namespace palpate
{
std::string checkStrainEnergy(StrainModel model, double parameter)
{
  if (model == StrainModel::Ogden &&
    !(parameter != 0.0 && std::abs(parameter) <= 50.0 && std::abs(parameter) >= 1e-3))
  {
    return joined(
      "Ogden's exponent must lie between 0.001 and 50, or their negatives, but is ", parameter);
  }
  if (model == StrainModel::Demiray && !(parameter > 0.0 && parameter <= 50.0))
  {
    return joined("Demiray's coefficient must be positive and at most 50, but is ", parameter);
  }
  return {};
}

std::string describe(const StrainLaw& law)
{
  switch (law.model)
  {
    case StrainModel::NeoHooke:
      return "finite strain (Neo-Hooke)";
    case StrainModel::Ogden:
      return joined("finite strain (Ogden, alpha = ", law.parameter, ")");
    case StrainModel::Demiray:
      return joined("finite strain (Demiray, b = ", law.parameter, ")");
    default:
      return "small strain";
  }
}
} // namespace palpate
