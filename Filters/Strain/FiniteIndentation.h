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
/// One layer of a body. Layers are listed from top to bottom.
struct FiniteLayer
{
  double thickness = std::numeric_limits<double>::infinity(); ///< mm; infinite for a half-space
  double youngsModulus = 0.1;                                 ///< MPa, at small strain
  double poissonRatio = 0.45;                                 ///< 0 to LargestPoissonsRatio
  StrainModel model = StrainModel::NeoHooke;
  double parameter = 0.0; ///< parameter of the model (StrainLaw.h)

  static constexpr double LargestPoissonsRatio = 0.4995;
};

/// A tool, and the layers into which it is pressed. The layers are bonded to each other.
struct FiniteProblem
{
  std::vector<FiniteLayer> layers; ///< the last may be a half-space; otherwise the base is rigid
  bool slipBase = false; ///< whether the last layer slips on the rigid base without friction
  /// Radius of the body's surface, mm. 0 is a flat surface. A positive radius is that of a ball
  /// that is pressed from two opposite sides. A negative radius is that of a spherical cavity that
  /// is pressed at one side. The magnitude must be at least two contact radii. On a curved surface
  /// the layers are shells, and the half-space is the rest of the ball or the body around the
  /// cavity.
  double bodyRadius = 0.0;
  /// Largest expected contact radius, mm. The mesh is generated for this radius.
  double contactRadius = 1.0;
  std::vector<double> depths; ///< depths of the tool's tip, mm, ascending, > 0
  /// Length of the elements under the tool relative to the contact radius, from ShortestEdge to
  /// LongestEdge.
  double edge = 0.05;

  static constexpr double ShortestEdge = 0.002; ///< results in about a million elements
  static constexpr double LongestEdge = 0.5;
};

/// The contact at one depth.
struct FinitePoint
{
  double depth = 0.0;         ///< mm
  double force = 0.0;         ///< N
  double contactRadius = 0.0; ///< mm, in the deformed body
  double energy = 0.0;        ///< stored energy, N mm
  double leastVolume = 1.0;   ///< smallest volume ratio J in the body
  int iterations = 0;         ///< iterations of Newton's method
};

/// The computed points of a curve, and the reason why further points are missing.
struct FiniteCurve
{
  std::vector<FinitePoint> points;
  std::string fault;
};

/**
 * Presses a tool of revolution without friction into a layered body at finite strain.
 *
 * Elements are axisymmetric, with nine nodes and quadratic displacements. The volume change is
 * projected on three linear functions per element (Q2/P1), so that nearly incompressible bodies do
 * not lock. The pressure is eliminated within the element, so that the solution is the minimum of
 * one potential. Energy and stress are those of StrainEnergy.h. Contact is a penalty potential
 * ½ε⟨-g⟩² of the signed distance g between points of the deformed surface and the tool; the error
 * of the force due to the penalty is corrected to first order. The equations are solved by Newton's
 * method. A step that turns an element inside out is shortened. A depth increment for which the
 * method does not converge is halved.
 *
 * The mesh of a half-space ends at a thousand contact radii, multiplied by the ratio of the modulus
 * of the stiffest layer to that of the half-space. The nodes at the end are fixed, which causes an
 * error of 0.1 %.
 *
 * If all layers are linear, kinematics and contact are linear, too. The points of the surface then
 * move straight down, below the undeformed tool, as in the laws of small strain. The ratio of the
 * finite-strain result to the linear result on the same mesh is the effect of finite strain. In
 * this ratio the error of the mesh almost cancels.
 *
 * `goOn(fraction)` is called with the completed fraction. If it returns false, the solution stops.
 * Cost: 0.1 to 0.3 s per iteration, 5 to 20 iterations per depth. Memory: about 100 MB.
 */
PALPATE_EXPORT FiniteCurve pressTool(const ToolOutline& tool, const FiniteProblem& problem,
  const std::function<bool(double)>& goOn = {});

/// Returns the fault of the problem with the layer and the value, or "".
PALPATE_EXPORT std::string checkProblem(const FiniteProblem& problem);
} // namespace palpate

#endif
