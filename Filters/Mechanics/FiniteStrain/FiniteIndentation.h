// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteIndentation_h
#define palpate_FiniteIndentation_h

#include "Mechanics/FiniteStrain/StrainEnergy.h"
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
  std::vector<FiniteLayer> layers; ///< the last may be a half-space, else it lies on a rigid base
  bool slipBase = false;           ///< that it slides on without friction
  /// Radius of the body's surface, mm: 0 flat; above 0 a ball, pressed from two opposite sides;
  /// below 0 a spherical cavity, pressed at one. At least two contact radii. Layers are shells; the
  /// half-space is the rest of the ball, or all that lies around the cavity.
  double bodyRadius = 0.0;
  /// The largest contact radius to be expected, mm: what the mesh is made for.
  double contactRadius = 1.0;
  std::vector<double> depths; ///< mm, of the tool's tip, ascending, > 0
  /// Length of the elements under the tool, of the contact radius, ShortestEdge to LongestEdge.
  double edge = 0.05;

  static constexpr double ShortestEdge = 0.002; ///< a million elements
  static constexpr double LongestEdge = 0.5;
};

/// What the tool feels at one depth.
struct FinitePoint
{
  double depth = 0.0;         ///< mm
  double force = 0.0;         ///< N
  double contactRadius = 0.0; ///< mm, in the deformed body
  double energy = 0.0;        ///< stored, N mm
  double leastVolume = 1.0;   ///< the smallest J
  int iterations = 0;         ///< of Newton's method
};

/// As far as it came, and why no further.
struct FiniteCurve
{
  std::vector<FinitePoint> points;
  std::string fault;
};

/**
 * Presses a tool of revolution without friction into a body of layers at finite strain.
 *
 * Axisymmetric elements of nine nodes with quadratic displacements, whose volume change is
 * projected on three linear functions each (Q2/P1: they do not lock where the body hardly changes
 * its volume; the pressure is eliminated within the element, so that all is the minimum of one
 * potential). Energy and stress of StrainEnergy.h; contact by a potential ½ε⟨-g⟩² of the signed
 * distance g between the points of the deformed surface and the tool, whose part in the force is
 * taken back to first order. Newton's method; a step that turns an element inside out is shortened,
 * an increment of depth that does not converge is halved.
 *
 * The half-space ends, held, at a thousand contact radii, or as many times more as it is softer
 * than what lies on it (an error of 0.1 %).
 *
 * Where all layers are linear, the strain is small in every sense: the points of the surface sink
 * straight down below the undeformed tool, as in the laws of the room beside. The ratio of both on
 * the same mesh is what finite strain does, almost free of the mesh's error.
 *
 * `goOn(fraction)` is told how far it is, and ends it by false. Cost: 0.1 to 0.3 s per iteration, 5
 * to 20 of these per depth. Memory: some 100 MB.
 */
PALPATE_EXPORT FiniteCurve pressTool(const ToolOutline& tool, const FiniteProblem& problem,
  const std::function<bool(double)>& goOn = {});

/// "" or what makes no sense in it, naming layer and number.
PALPATE_EXPORT std::string checkProblem(const FiniteProblem& problem);
} // namespace palpate

#endif
