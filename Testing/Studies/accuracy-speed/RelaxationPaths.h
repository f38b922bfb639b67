// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mechanics/Relaxation/PronySeries.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::testing
{
/// A press over time, with the exact forces on a tool of f = δ^m on a material that relaxes. mm, s,
/// N.
struct RelaxationPath
{
  std::string name;
  std::string source; ///< source of the exact forces
  double exponent = 1.0;
  PronySeries series;
  std::vector<double> depths; ///< depth at each tick, <= 1 mm; the tick before the first is outside
  /// Ticks to compare, counted from 0, and the exact forces there.
  std::vector<std::size_t> ticks;
  std::vector<double> forces;
  double largest = 0.0; ///< force on the whole path
};

constexpr double RelaxationPeriod = 1e-3; // s

/// All paths of the study: the tables of `folder`/Reference/rate (stop and go; Ting's points) for
/// flat, paraboloid and cone, and presses, holds and sines. The exact forces of the presses, holds
/// and sines come from a RelaxationFoundation with so many elements that a different number hardly
/// changes the forces.
std::vector<RelaxationPath> relaxationPaths(const std::string& folder);
/// The stop-and-go path with three branches, which is timed and drawn.
RelaxationPath stopAndGo(const std::string& folder, double exponent);

/// Returns the forces for f = δ^m of a foundation with `elements` elements. Each tick is divided
/// into `substeps` steps, in which the depth is linear.
std::vector<double> foundationForces(
  const RelaxationPath& path, std::size_t elements, int substeps);

const char* toolOfExponent(double exponent);
} // namespace palpate::testing
