// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectContact_h
#define palpate_DirectContact_h

#include "Solids/FiniteElements/UnitLoads.h"
#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/ToolFacets.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace palpate
{
/// Direction of the pressures.
enum class Pushed
{
  TogetherAlongTheMean, ///< along the mean of the normals, weighted by the force on each corner
  EachAlongItsOwn
};

/// Force, stiffness and contact radius at one depth of the tool.
struct DirectForce
{
  /// Force along the direction of the press, N; NaN if no converged contact was found.
  double force = 0.0;
  double stiffness = 0.0; ///< N/mm
  double radius = 0.0;    ///< radius of the circle with the same area as the contact, mm
};

/**
 * A tool pressed straight into an elastic body of hexahedra or tetrahedra. The solution uses
 * neither a Green function nor a half-space nor a law of contact.
 *
 * The pressures are linear on the body's facets between their corners. The condition of no
 * penetration is satisfied on average: it applies to the mean of the gap, weighted over the facets
 * around each corner. Gaps are measured along the tool's axis. The model is linear in displacements
 * and gaps, unilateral and without friction. The mesh must be fine under the tool: with four
 * quadratic facets over the contact radius the force of a sphere is within 1 % (DirectContactTest).
 *
 * Without friction, the pressures act along the normal of the contact. During the press this
 * direction changes from the body's normal to the tool's normal. A solution at finite strain
 * includes this effect and all other terms of second order. On balls and in cavities with radii
 * down to three contact radii, the force at finite strain is within 1 % of the force with pressures
 * along the mean normal, and up to 4 % above the force with each pressure along its own normal. If
 * the tool touches walls on several sides, either variant may be more accurate. Their difference is
 * a measure of the error, and only pressAtFiniteStrain() shows which variant is correct.
 *
 * The body may be a part that was cut out of a larger body and is held on the cut. `rest` then
 * contains the motion of the part due to the surrounding body.
 *
 * Cost: three solutions per corner that may touch.
 */
class PALPATE_EXPORT DirectContact
{
public:
  /// The tool must outlive this object. `deepest` is the largest depth at which at() is called, mm.
  /// The mean direction of the pressures is computed at this depth.
  DirectContact(const ElasticBody& body, const AxisymmetricTool& tool, const DirectPlace& at,
    double deepest, const UnitMotion* rest = nullptr);

  /// Returns the number of corners that may touch.
  int corners() const { return static_cast<int>(this->Corners.size()); }

  /// Returns the distance (mm) between the first touch at another place of the body and the touch
  /// at the point. It is > 0 in a hollow that is too narrow for the tool. If it exceeds the depth,
  /// the displacements of the walls are too large for the assumption of small displacements.
  double touchesBefore() const;

  DirectForce at(double deflection, Pushed pushed = Pushed::TogetherAlongTheMean) const;

private:
  /// A piece of the surface, in coordinates of the tool.
  struct Piece
  {
    double depth;  ///< position along the tool's axis, inwards, mm
    double away;   ///< distance from the tool's axis, mm
    double weight; ///< weight in the mean over the pieces of the corner
  };
  /// A part of the surface around a corner of the facets, with one displacement and one pressure.
  struct Corner
  {
    std::vector<Piece> pieces;
    std::vector<std::pair<std::int32_t, double>> nodes; ///< nodes and their weights
    /// Inward normal, scaled to the component 1 along the axis.
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double area = 0.0; ///< area projected along the axis, mm²
  };

  void takeCorners(const std::vector<ToolFacet>& facets);
  Eigen::MatrixXd compliance(const ElasticBody& body) const;
  void addRest(const ElasticBody& body, const UnitMotion& rest, Eigen::MatrixXd& compliance) const;
  /// Returns the compliance between the corners: the displacements along `pushes` under unit forces
  /// along `pushes`. `pushes` has one column per corner.
  Eigen::MatrixXd along(const Eigen::MatrixXd& compliance, const Eigen::Matrix3Xd& pushes) const;
  void pushAlongMean(const Eigen::MatrixXd& compliance, double deepest);
  /// Finds the forces on the corners along the axis (N), and the corners that touch. Returns false
  /// if the iteration does not converge.
  bool solve(double deflection, const Eigen::MatrixXd& compliance, Eigen::VectorXd& forces,
    std::vector<int>& active) const;

  const AxisymmetricTool& Tool;
  DirectPlace At;
  Eigen::Matrix3d Frame; ///< columns: two tangents and the inward direction
  double Reached;        ///< radius beyond which no part of the tool can touch, mm
  std::vector<Corner> Corners;
  /// Compliance between the corners along the directions of pressure, mm/N, for each value of
  /// Pushed.
  std::array<Eigen::MatrixXd, 2> Compliance;
};
} // namespace palpate

#endif
