// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_StrainLaw_h
#define palpate_StrainLaw_h

#include "Mechanics/FiniteStrain/StrainEnergy.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
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
