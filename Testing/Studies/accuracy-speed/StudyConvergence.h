// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StudyScene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::testing
{
/// Relative RMS error of one method at one size.
struct ConvergencePoint
{
  std::string body;
  std::string method;
  double size = 0.0; ///< mean edge, mm; or number of samples
  double error = 0.0;
};

/**
 * Error over the size of the mesh, with the first tool. Bodies: a ball of 40 mm with the half-space
 * law, compared with the ball without a mesh; a flat face over an uneven base (8 to 12 mm),
 * compared with the law with the local thickness; and the head's meshes, if given, compared with
 * their reference.
 */
std::vector<ConvergencePoint> meshConvergence(
  const StudyEffort& effort, const StudyScene* head, bool isQuick);

/// Error over the number of samples and their width, for each tool of a scene.
std::vector<ConvergencePoint> sampleConvergence(const StudyScene& scene);
} // namespace palpate::testing
