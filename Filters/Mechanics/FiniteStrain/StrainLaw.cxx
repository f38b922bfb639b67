// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/StrainLaw.h"

#include "Mechanics/JoinedText.h"

namespace palpate
{
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
