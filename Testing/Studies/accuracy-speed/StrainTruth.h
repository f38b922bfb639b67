// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MethodTimer.h"

#include <iosfwd>
#include <string>

namespace palpate::testing
{
/**
 * Accuracy of responses at the depths of palpation, against finite strain itself from two codes
 * (FOLDER/finite-strain/curves.csv, FOLDER/calculix). For each body, tool and Poisson's ratio it
 * compares the responses that Palpate stores: the law of small strain, the same with the curvature
 * of the body, and with finite strain. All are ticks of the same kernel on the same mesh.
 * Writes CSV (README.md, "Finite strain"): a row per response and depth, and a row with the times
 * if there is a timer. With `deep` also the depths beyond the tables, where the solver is used
 * (half a minute a curve). Throws std::runtime_error if a file cannot be read.
 */
void studyStrain(std::ostream& stream, const std::string& folder, bool deep, MethodTimer* timer);
} // namespace palpate::testing
