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
/// Which way pressures act.
enum class Pushed
{
  TogetherAlongTheMean, ///< of the normals, by what each carries
  EachAlongItsOwn
};

/// A contact at a depth.
struct DirectForce
{
  double force = 0.0;     ///< along the way in, N; NaN where no contact was found that settles
  double stiffness = 0.0; ///< N/mm
  double radius = 0.0;    ///< of a circle of the area that is touched, mm
};

/**
 * A tool pressed straight into an elastic body of hexahedra or tetrahedra: no Green function, no
 * half-space, no law of contact.
 *
 * Pressures are linear on the body's facets between their corners, and so are the gaps that must
 * not close: each corner's mean of them over the facets around it. Gaps are told along the tool's
 * axis. Linear in displacements and gaps, unilateral, without friction. The mesh must be fine under
 * the tool: with four quadratic facets over the contact's radius the force of a sphere is within
 * 1 % (DirectContactTest).
 *
 * Without friction pressures act along the normal, which turns from the body's to the tool's while
 * it is pressed. What that does to second order, with all else that is of this order, finite strain
 * tells: on balls and in cavities down to three contact radii it is within 1 % of pressures along
 * the mean normal, and up to 4 % above those each along its own. Where walls on several sides are
 * touched either may be nearer: how far both differ tells how far one can be trusted, and
 * pressAtFiniteStrain() decides.
 *
 * The body may be a part cut out of a larger one and held on the cut: `rest` then tells how it
 * moves with what is around it.
 *
 * Cost: three solutions per corner that may touch.
 */
class PALPATE_EXPORT DirectContact
{
public:
  /// The tool must stay. `deepest` (mm) of the depths to be asked for, at which the mean is told.
  DirectContact(const ElasticBody& body, const AxisymmetricTool& tool, const DirectPlace& at,
    double deepest, const UnitMotion* rest = nullptr);

  /// How many corners may touch.
  int corners() const { return static_cast<int>(this->Corners.size()); }

  /// Mm by which the tool touches elsewhere before it comes to the place, as in a hollow too narrow
  /// for it. Beyond the depth walls are pushed aside too far for small displacements.
  double touchesBefore() const;

  DirectForce at(double deflection, Pushed pushed = Pushed::TogetherAlongTheMean) const;

private:
  /// A piece of the surface, seen from the tool.
  struct Piece
  {
    double depth;  ///< along its axis inwards, mm
    double away;   ///< from its axis, mm
    double weight; ///< of the corner's mean
  };
  /// What moves, and carries pressure, as one.
  struct Corner
  {
    std::vector<Piece> pieces;
    std::vector<std::pair<std::int32_t, double>> nodes; ///< and their shares
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< inwards, 1 along the axis
    double area = 0.0;                                  ///< mm², across the axis
  };

  void takeCorners(const std::vector<ToolFacet>& facets);
  Eigen::MatrixXd compliance(const ElasticBody& body) const;
  void addRest(const ElasticBody& body, const UnitMotion& rest, Eigen::MatrixXd& compliance) const;
  /// What forces of 1 along the axis are, column by column.
  Eigen::MatrixXd along(const Eigen::MatrixXd& compliance, const Eigen::Matrix3Xd& pushes) const;
  void pushAlongMean(const Eigen::MatrixXd& compliance, double deepest);
  /// On the corners, along the axis, N, and which touch; false where none settle.
  bool solve(double deflection, const Eigen::MatrixXd& compliance, Eigen::VectorXd& forces,
    std::vector<int>& active) const;

  const AxisymmetricTool& Tool;
  DirectPlace At;
  Eigen::Matrix3d Frame; ///< columns: two across, one inwards
  double Reached;        ///< radius beyond which nothing of the tool is
  std::vector<Corner> Corners;
  /// Corner by corner, along their pushes, mm/N; for each Pushed.
  std::array<Eigen::MatrixXd, 2> Compliance;
};
} // namespace palpate

#endif
