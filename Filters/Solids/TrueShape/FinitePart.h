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
 * The potential of a body of quadratic tetrahedra and a tool in it, by the displacements of the
 * body's nodes: energies of FiniteTetrahedron, and ½ε⟨-g⟩² over the undeformed surface, g the
 * signed distance from the tool. Without friction.
 *
 * Of a part cut out of a larger body the nodes on the cut move together, as those of the larger one
 * under a load: the numbers of that are unknowns, too, the last, and what is around stores its
 * energy (PartRest). At small strain they are then the load's.
 */
class FinitePart
{
public:
  using Vector = Eigen::VectorXd;

  /// The body, of one material, and the outline must stay. `deepest` (mm) that is to be pressed;
  /// `rest` null: held nodes do not move.
  FinitePart(const ElasticBody& body, const AxisymmetricTool& tool, const ToolOutline& outline,
    const DirectPlace& at, double deepest, const UnitMotion* rest);

  Eigen::Index unknowns() const { return this->free() + this->loads(); }
  bool isTouched() const { return !this->Surface.empty(); }
  /// Where the tool first touches the undeformed body, mm: 0, or above, less than 0, in a hollow
  /// that is too narrow for it.
  double firstTouch() const;

  /// N mm, where the tool's tip is `depth` (mm) deep; +inf where the body is inside out.
  double energy(const Vector& u, double depth) const;

  /// How a tool that is still far too deep bends the tangent.
  enum class Bending
  {
    AsItDoes,
    LeftOut ///< which it must be where the tangent is not positive with it
  };
  /// Its gradient; the next three are then its second derivatives there.
  void linearize(const Vector& u, double depth, Bending bending, Vector& gradient);
  /// Adds a share of what these are at rest.
  void stiffen(double share);
  const SymmetricSparse& stiffness() const { return this->Stiffness.lower; } ///< by nodes
  const Eigen::MatrixXd& border() const { return this->Border; }             ///< nodes × load
  const Eigen::MatrixXd& corner() const { return this->Corner; }             ///< load × load

  struct Pressed
  {
    double force = 0.0;       ///< of the tool along its way in, N
    double radius = 0.0;      ///< of a circle of the undeformed area that is touched, mm
    double penetration = 0.0; ///< that the penalty leaves, the mean by pressure, mm
    double turned = 0.0;      ///< angle by which what is around turns the place, rad
    Vector gradient;          ///< by the depth, of the potential's gradient
  };
  Pressed pressed(const Vector& u, double depth) const;

private:
  using Piece = SurfacePiece; ///< its place in the tool's frame
  struct Gap
  {
    double value;             ///< mm, > 0 outside
    Eigen::Vector3d gradient; ///< by the displacement
    Eigen::Matrix3d hessian;
  };

  Eigen::Index free() const { return this->Stiffness.lower.rows(); }
  Eigen::Index loads() const { return this->Rest.motion.cols(); }
  void takeSurface(const std::vector<ToolFacet>& facets);
  FiniteTetrahedron::Vector gather(const VolumeElement& element, const Vector& u) const;
  double displacement(std::int32_t node, int axis, const Vector& u) const;
  /// How the load moves an element's held nodes.
  Eigen::MatrixXd restOf(const VolumeElement& element) const;
  /// Adds a force on a node to a gradient.
  void addForce(std::int32_t node, const Eigen::Vector3d& force, Vector& gradient) const;
  void addBorder(const VolumeElement& element, const ElementMatrix& stiffness);
  double distance(const Piece& piece, const Vector& u, double depth) const;
  Gap gapAt(const Piece& piece, const Vector& u, double depth) const;
  Eigen::Vector3d placeOf(const Piece& piece, const Vector& u) const;
  /// Calls visit(piece, gap) for what is inside the tool.
  template <class Visit>
  void visitTouched(const Vector& u, double depth, const Visit& visit) const;
  void linearizeBody(const Vector& u, Vector& gradient);
  void addContact(const Piece& piece, const Gap& gap, Bending bending, Vector& gradient);

  const ElasticBody& Body;
  const ToolOutline& Tool;
  Eigen::Matrix3d Frame;
  double Penalty; ///< MPa/mm
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
