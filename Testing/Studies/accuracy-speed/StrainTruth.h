// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MethodTimer.h"

#include <iosfwd>
#include <string>

namespace palpate::testing
{
/**
 * What responses are worth where people press: against finite strain itself, by two codes
 * (FOLDER/finite-strain/curves.csv, FOLDER/calculix), each body, tool and Poisson's ratio with the
 * responses that Palpate stores of it: the law of small strain, the same with the curvature of the
 * body, and with finite strain. All are ticks of the same kernel on the same mesh.
 *
 * Writes CSV (README.md, "Finite strain"): a row per response and depth, and one with its times,
 * where there is a timer. With `deep` also where no table reaches and the solver is asked (half a
 * minute a curve). Throws std::runtime_error where a file cannot be read.
 */
void studyStrain(std::ostream& stream, const std::string& folder, bool deep, MethodTimer* timer);
} // namespace palpate::testing
