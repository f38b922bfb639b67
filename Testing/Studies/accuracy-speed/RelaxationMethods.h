// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "Mechanics/Relaxation/PronySeries.h"

#include <memory>
#include <vector>

namespace palpate::testing
{
/// Methods for a body that relaxes, with f = δ^exponent N to 1 mm, on a plate in z = 0. Each
/// force() is a tick of RelaxationPeriod. The last method is the exact one.
std::vector<std::unique_ptr<ContactMethod>> relaxationMethods(
  double exponent, const PronySeries& series);

/// A tip at this depth over the plate, away from edges and corners of its triangles.
Vector3 relaxationTip(double depth);
} // namespace palpate::testing
