// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FinitePart_h
#define palpate_FinitePart_h

#include "Solids/FiniteElements/UnitLoads.h"
#include "Solids/TrueShape/FiniteTetrahedron.h"
#include "Mechanics/FiniteStrain/ToolOutline.h"
#include "Solids/TrueShape/PartRest.h"
#include "Solids/TrueShape/ToolFacets.h"

#include <vector>

namespace palpate
{
/**
 * The potential of a body of quadratic tetrahedra and of a tool that is pressed into it, as a
 * function of the displacements of the body's nodes. It is the sum of the energies of
 * FiniteTetrahedron and of the integral of ½ε⟨-g⟩² over the undeformed surface, where ε is the
 * penalty and g the signed distance from the tool. Friction is not included.
 *
 * If the body is a part that was cut out of a larger body, the nodes on the cut have the motion of
 * the larger body under certain loads. The magnitudes of these loads are the last unknowns. The
 * surrounding body stores the energy of this motion (PartRest). At small strain, these unknowns are
 * equal to the load of the tool.
 */
class FinitePart
{
public:
  using Vector = Eigen::VectorXd;

  /// The body and the outline must outlive this object. The body must have one material. `deepest`
  /// is the largest depth, mm. If `rest` is null, held nodes do not move.
  FinitePart(const ElasticBody& body, const AxisymmetricTool& tool, const ToolOutline& outline,
    const DirectPlace& at, double deepest, const UnitMotion* rest);

  Eigen::Index unknowns() const { return this->free() + this->loads(); }
  bool isTouched() const { return !this->Surface.empty(); }
  /// Returns the depth at which the tool first touches the undeformed body, mm. It is 0, or less
  /// than 0 in a hollow that is too narrow for the tool.
  double firstTouch() const;

  /// Returns the potential, N mm, with the tool's tip at `depth` (mm). It is +inf if an element is
  /// inverted.
  double energy(const Vector& u, double depth) const;

  /// Whether the tangent includes the curvature of the tool's surface. The curvature matters while
  /// the tool penetrates too deeply.
  enum class ToolCurvature
  {
    Included,
    Omitted ///< used if the tangent with the curvature is not positive definite
  };
  /// Computes the gradient of the potential. stiffness(), border() and corner() are then the second
  /// derivatives of the potential.
  void linearize(const Vector& u, double depth, ToolCurvature curvature, Vector& gradient);
  /// Adds a fraction of the second derivatives in the undeformed state to stiffness(), border() and
  /// corner().
  void stiffen(double share);
  /// Second derivatives of the potential, nodes × nodes.
  const SymmetricSparse& stiffness() const { return this->Stiffness.lower; }
  /// Second derivatives of the potential, nodes × loads.
  const Eigen::MatrixXd& border() const { return this->Border; }
  /// Second derivatives of the potential, loads × loads.
  const Eigen::MatrixXd& corner() const { return this->Corner; }

  struct Pressed
  {
    double force = 0.0;  ///< force on the tool along the direction of the press, N
    double radius = 0.0; ///< radius of the circle with the same undeformed area as the contact, mm
    /// Penetration due to the penalty, as the mean weighted by pressure, mm.
    double penetration = 0.0;
    /// Angle by which the motion of the surrounding body rotates the place, rad.
    double turned = 0.0;
    Vector gradient; ///< derivative of the potential's gradient with respect to depth
  };
  Pressed pressed(const Vector& u, double depth) const;

private:
  using Piece = SurfacePiece; ///< A position in the tool's frame.
  struct Gap
  {
    double value;             ///< gap, mm, > 0 outside the tool
    Eigen::Vector3d gradient; ///< gradient with respect to the displacement
    Eigen::Matrix3d hessian;
  };

  Eigen::Index free() const { return this->Stiffness.lower.rows(); }
  Eigen::Index loads() const { return this->Rest.motion.cols(); }
  void takeSurface(const std::vector<ToolFacet>& facets);
  FiniteTetrahedron::Vector gather(const VolumeElement& element, const Vector& u) const;
  double displacement(std::int32_t node, int axis, const Vector& u) const;
  /// Returns the motion of an element's held nodes per unit load.
  Eigen::MatrixXd restOf(const VolumeElement& element) const;
  /// Adds a force on a node to a gradient.
  void addForce(std::int32_t node, const Eigen::Vector3d& force, Vector& gradient) const;
  void addBorder(const VolumeElement& element, const ElementMatrix& stiffness);
  double distance(const Piece& piece, const Vector& u, double depth) const;
  Gap gapAt(const Piece& piece, const Vector& u, double depth) const;
  Eigen::Vector3d placeOf(const Piece& piece, const Vector& u) const;
  /// Calls visit(piece, gap) for each piece that is inside the tool.
  template <class Visit>
  void visitTouched(const Vector& u, double depth, const Visit& visit) const;
  void linearizeBody(const Vector& u, Vector& gradient);
  void addContact(const Piece& piece, const Gap& gap, ToolCurvature curvature, Vector& gradient);

  const ElasticBody& Body;
  const ToolOutline& Tool;
  Eigen::Matrix3d Frame;
  double Penalty; ///< stiffness of the penalty, MPa/mm
  std::vector<FiniteTetrahedron> Elements;
  std::vector<Piece> Surface;
  PartRest Rest;
  StiffnessMatrix Stiffness;
  Eigen::MatrixXd Border;
  Eigen::MatrixXd Corner;
  SymmetricSparse StiffnessAtRest;
  Eigen::MatrixXd BorderAtRest;
  Eigen::MatrixXd CornerAtRest;
};
} // namespace palpate

#endif
