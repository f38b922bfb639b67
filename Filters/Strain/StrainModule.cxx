// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/FiniteStrain/StrainModule.h"

#include "Strain/SolvedTable.h"

extern "C" PALPATE_EXPORT const palpate::ModuleTable* palpateStrainModule()
{
  static const palpate::StrainModule module{ { PALPATE_VERSION }, palpate::solveOnHalfSpace,
    palpate::solveOnLayers };
  return &module;
}
