// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Solids/FiniteElements/ElasticBody.h"
#include "FiniteScene.h"

namespace palpate::testing
{

/// Steps of size `spacing` up to `fine`. After that each step is `growth` times the preceding one,
/// up to `largest`.
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
 * The scene's body of hexahedra: of size `spacing` across the window and for the first element
 * below the surface, and coarser elsewhere. Its supports are given by FixedX, FixedY, FixedZ. Body
 * and deformation under vertical forces are mirror-symmetric about x = 0 and y = 0. The supports
 * that prevent a rigid motion of a plate on edges carry no force.
 */
ElasticBodyInput gradedBlock(const FiniteScene& scene, const FiniteMesh& mesh);

} // namespace palpate::testing
