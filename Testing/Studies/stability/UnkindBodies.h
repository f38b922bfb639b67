// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_UnkindBodies_h
#define palpate_testing_UnkindBodies_h

#include "SampleBodies.h"

#include <string>
#include <vector>

namespace palpate::testing
{
/// A body with sharp features, and a closed path of a tip over them, mostly 1 mm deep. mm.
struct UnkindBody
{
  std::string name;
  Surface surface;
  std::vector<Vector3> path; ///< corners; begins and ends outside, at the same place
  /// |ΔF| over the force, and the jump of the contact point (mm), that the nearest point has on
  /// this path: 2 cos(ω/2), 2 δ cos(ω/2) where it crosses from face to face of an edge of interior
  /// angle ω.
  double forceJump;
  double contactJump;
};

constexpr double UnkindDepth = 1.0; // mm

std::vector<UnkindBody> unkindBodies();
} // namespace palpate::testing

#endif
