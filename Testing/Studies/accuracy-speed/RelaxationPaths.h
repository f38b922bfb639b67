// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Mechanics/Relaxation/PronySeries.h"

#include <cstddef>
#include <string>
#include <vector>

namespace palpate::testing
{
/// A press over time, and what is right for a tool of f = δ^m on a material that relaxes. mm, s, N.
struct RelaxationPath
{
  std::string name;
  std::string source; ///< of the truth
  double exponent = 1.0;
  PronySeries series;
  std::vector<double> depths; ///< at each tick, the first one after a tick outside; <= 1 mm
  /// Ticks that are compared, from 0, and the forces there.
  std::vector<std::size_t> ticks;
  std::vector<double> forces;
  double largest = 0.0; ///< force of the whole path
};

constexpr double RelaxationPeriod = 1e-3; // s

/// All of the study: the tables of `folder`/Reference/rate (stop and go; Ting's points) for flat,
/// paraboloid and cone, and presses, holds and sines whose truth is a foundation of so many
/// elements (RelaxationFoundation) that another number hardly changes it.
std::vector<RelaxationPath> relaxationPaths(const std::string& folder);
/// The path of stop and go, of three branches: the one that is timed and drawn.
RelaxationPath stopAndGo(const std::string& folder, double exponent);

/// F of f = δ^m of a foundation of `elements`, stepped `substeps` times a tick along straight ways.
std::vector<double> foundationForces(
  const RelaxationPath& path, std::size_t elements, int substeps);

const char* toolOfExponent(double exponent);
} // namespace palpate::testing
