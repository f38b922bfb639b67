// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_UnkindBodies_h
#define palpate_testing_UnkindBodies_h

#include "SampleBodies.h"

#include <string>
#include <vector>

namespace palpate::testing
{
/// A body with sharp features, and a closed path of a tip over them, mostly at a depth of 1 mm. mm.
struct UnkindBody
{
  std::string name;
  Surface surface;
  std::vector<Vector3> path; ///< corners; begins and ends outside, at the same place
  /// |ΔF| over the force, and the jump of the contact point (mm), for a method that uses the
  /// nearest point on this path. They are 2 cos(ω/2) and 2 δ cos(ω/2) if the path crosses an edge
  /// of interior angle ω from face to face.
  double forceJump;
  double contactJump;
};

constexpr double UnkindDepth = 1.0; // mm

std::vector<UnkindBody> unkindBodies();
} // namespace palpate::testing

#endif
