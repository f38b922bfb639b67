// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteIndentation_h
#define palpate_FiniteIndentation_h

#include "Strain/StrainEnergy.h"
#include "Mechanics/FiniteStrain/ToolOutline.h"
#include "Mechanics/PalpateExport.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace palpate
{
/// A layer of a body, from the top.
struct FiniteLayer
{
  double thickness = std::numeric_limits<double>::infinity(); ///< mm; infinite: a half-space
  double youngsModulus = 0.1;                                 ///< MPa, at small strain
  double poissonsRatio = 0.45;                                ///< 0 to LargestPoissonsRatio
  StrainModel model = StrainModel::NeoHooke;
  double parameter = 0.0; ///< of the model

  static constexpr double LargestPoissonsRatio = 0.4995;
};

/// A tool and the layers it is pressed into, bonded to each other.
struct FiniteProblem
{
  std::vector<FiniteLayer>
    layers;              ///< the last may be a half-space, otherwise it lies on a rigid base
  bool slipBase = false; ///< on which it slips without friction
  /// Radius of the body's surface, mm: 0 flat; above 0 a ball, pressed from two opposite sides;
  /// below 0 a spherical cavity, pressed at one. At least two contact radii. Layers are shells; the
  /// half-space is the rest of the ball, or the body around the cavity.
  double bodyRadius = 0.0;
  /// The largest contact radius expected, mm, for which the mesh is made.
  double contactRadius = 1.0;
  std::vector<double> depths; ///< mm, of the tool's tip, ascending, > 0
  /// Length of the elements under the tool, relative to the contact radius, ShortestEdge to
  /// LongestEdge.
  double edge = 0.05;

  static constexpr double ShortestEdge = 0.002; ///< a million elements
  static constexpr double LongestEdge = 0.5;
};

/// The contact at one depth.
struct FinitePoint
{
  double depth = 0.0;         ///< mm
  double force = 0.0;         ///< N
  double contactRadius = 0.0; ///< mm, in the deformed body
  double energy = 0.0;        ///< stored, N mm
  double leastVolume = 1.0;   ///< the smallest J
  int iterations = 0;         ///< of Newton's method
};

/// The points found, and why there are no more.
struct FiniteCurve
{
  std::vector<FinitePoint> points;
  std::string fault;
};

/**
 * Presses a tool of revolution without friction into a body of layers at finite strain.
 *
 * Axisymmetric elements of nine nodes with quadratic displacements, whose volume change is
 * projected on three linear functions each (Q2/P1: no locking of nearly incompressible bodies; the
 * pressure is eliminated within the element, so that the solution is the minimum of one potential).
 * Energy and stress of StrainEnergy.h; contact by a potential ½ε⟨-g⟩² of the signed distance g
 * between the points of the deformed surface and the tool, whose effect on the force is corrected
 * to first order. Newton's method; a step that turns an element inside out is shortened, an
 * increment of depth that does not converge is halved.
 *
 * The half-space ends, fixed, at a thousand contact radii, times the ratio by which it is softer
 * than the layers on it (an error of 0.1 %).
 *
 * If all layers are linear, kinematics and contact are linear, too: the points of the surface move
 * straight down below the undeformed tool, as in the laws of small strain. The ratio of both on the
 * same mesh is the effect of finite strain, almost free of the mesh's error.
 *
 * `goOn(fraction)` gets the fraction done; returning false ends it. Cost: 0.1 to 0.3 s per
 * iteration, 5 to 20 of these per depth. Memory: some 100 MB.
 */
PALPATE_EXPORT FiniteCurve pressTool(const ToolOutline& tool, const FiniteProblem& problem,
  const std::function<bool(double)>& goOn = {});

/// What is wrong with the problem, naming layer and number, or "".
PALPATE_EXPORT std::string checkProblem(const FiniteProblem& problem);
} // namespace palpate

#endif
