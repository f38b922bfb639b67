// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "MethodTimer.h"

#include <iosfwd>
#include <string>

namespace palpate::testing
{
/**
 * Accuracy of responses at the depths of palpation, against curves of two codes with finite strain
 * (FOLDER/finite-strain/curves.csv, FOLDER/calculix). For each body, tool and Poisson's ratio it
 * compares the responses that Palpate stores: with small strain, with the curvature of the body in
 * addition, and with finite strain. All are evaluated by the same kernel on the same mesh. Writes
 * CSV (README.md, "Finite strain"): a row per response and depth, and a row with the times if there
 * is a timer. With `deep` it includes the depths beyond the tables, for which the solver is used
 * (half a minute per curve). Throws std::runtime_error if a file cannot be read.
 */
void studyStrain(std::ostream& stream, const std::string& folder, bool deep, MethodTimer* timer);
} // namespace palpate::testing
