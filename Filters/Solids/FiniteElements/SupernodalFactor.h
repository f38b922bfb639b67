// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SupernodalFactor_h
#define palpate_SupernodalFactor_h

#include "Solids/FiniteElements/StiffnessFactor.h"

namespace palpate
{
/// Returns CHOLMOD's supernodal factor. Returns null if Palpate was built without CHOLMOD.
std::unique_ptr<StiffnessFactor> makeSupernodalFactor();
} // namespace palpate

#endif
