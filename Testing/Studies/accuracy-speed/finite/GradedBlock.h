// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Solids/FiniteElements/ElasticBody.h"
#include "FiniteScene.h"

namespace palpate::testing
{

/// Steps of `spacing` up to `fine`, then each `growth` times the last, up to `largest`.
struct Grading
{
  double spacing;
  double fine;
  double growth;
  double largest;
};
/// Coordinates from 0 to `length`; the growing steps are stretched or shrunk a little to fit.
std::vector<double> gradedSteps(const Grading& grading, double length);

/**
 * The scene's body of hexahedra: `spacing` across the window and for the first element of depth,
 * coarser away from it; what holds it as FixedX, FixedY, FixedZ. Mirror-symmetric about x = 0 and y
 * = 0, and so is its answer to vertical forces: what keeps a plate on edges from drifting takes no
 * force.
 */
ElasticBodyInput gradedBlock(const FiniteScene& scene, const FiniteMesh& mesh);

} // namespace palpate::testing
