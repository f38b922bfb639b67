// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <memory>
#include <vector>

namespace palpate::testing
{
/// Ways to render a body that relaxes, of f = δ^exponent N to 1 mm, on a plate in z = 0: each a
/// tick of RelaxationPeriod at every force(). The last is what is right.
std::vector<std::unique_ptr<ContactMethod>> relaxationMethods(
  double exponent, const PronySeries& series);

/// On this plate, away from edges and corners of its triangles.
Vector3 relaxationTip(double depth);
} // namespace palpate::testing
