// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Solids/FiniteElements/ElasticBody.h"
#include "FiniteScene.h"

namespace palpate::testing
{

/// Steps of `spacing` up to `fine`, then each is `growth` times the last, up to `largest`.
struct Grading
{
  double spacing;
  double fine;
  double growth;
  double largest;
};
/// Coordinates from 0 to `length`. The growing steps are scaled a little to fit.
std::vector<double> gradedSteps(const Grading& grading, double length);

/**
 * The scene's body of hexahedra: `spacing` across the window and for the first element of depth,
 * coarser away from it. Its supports are given by FixedX, FixedY, FixedZ. Body and deformation
 * under vertical forces are mirror-symmetric about x = 0 and y = 0: the supports that keep a plate
 * on edges from drifting carry no force.
 */
ElasticBodyInput gradedBlock(const FiniteScene& scene, const FiniteMesh& mesh);

} // namespace palpate::testing
