// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteBody_h
#define palpate_FiniteBody_h

#include "Strain/FiniteIndentation.h"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/**
 * The potential of a layered body and a tool pressed into it, as a function of the displacements of
 * the nodes (FiniteIndentation.h). z points out of the body, whose surface is at z = 0. The tip of
 * the tool is at z = -depth.
 */
class FiniteBody
{
public:
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;
  using Solver = Eigen::SimplicialLDLT<Matrix, Eigen::Lower>;

  FiniteBody(const ToolOutline& tool, const FiniteProblem& problem);

  Eigen::Index unknowns() const { return this->Unknowns; }
  /// The lower triangle of the tangent from the last linearize().
  const Matrix& pattern() const { return this->Tangent; }

  /// Returns the potential, N mm; +inf if an element of the body is turned inside out.
  double energy(const Vector& u, double depth) const;
  /// Computes the gradient and the tangent of the potential.
  void linearize(const Vector& u, double depth, Vector& gradient);
  /// Updates the pressures after a step. Must be called with each step that is computed from the
  /// last linearization.
  void follow(const Vector& step);
  /// Clears the pressures. To be called if `u` was changed other than by a step of Newton's method.
  void restart() { this->Pressures.clear(); }
  /// Computes all results except the number of iterations. The force is that of the penalty,
  /// without the first-order correction.
  FinitePoint evaluate(const Vector& u, double depth) const;
  /// Derivatives with respect to the depth at an equilibrium: those of the displacements, and of
  /// the energy of the penalty (N). `solver` holds the factorized tangent of this equilibrium.
  struct Course
  {
    Vector motion;
    double penaltySlope;
  };
  Course course(const Vector& u, double depth, const Solver& solver) const;

private:
  static constexpr int ElementUnknowns = 18; ///< u_r and u_z of nine nodes
  using ElementVector = Eigen::Matrix<double, ElementUnknowns, 1>;
  using ElementMatrix = Eigen::Matrix<double, ElementUnknowns, ElementUnknowns>;

  struct Element
  {
    std::array<int, 9> nodes;
    std::size_t layer;
    Eigen::Matrix<double, 2, 9> places; ///< (r, z) of the nodes, mm
  };
  struct Material
  {
    StrainEnergy energy;
    double bulkModulus;
  };
  /// A Gauss point on an edge of the surface.
  struct SurfacePoint
  {
    std::array<int, 3> nodes;
    std::array<double, 3> shape;
    Eigen::Vector2d place; ///< (r, z) in the undeformed body, mm
    double weight;         ///< mm²
  };
  struct Gap
  {
    double value;             ///< distance from the tool, mm, positive outside
    Eigen::Vector2d gradient; ///< gradient with respect to the displacement
    Eigen::Matrix2d hessian;
    double byDepth;
    Eigen::Vector2d gradientByDepth;
  };

  /// The change of an element's pressure in a step of Newton's method, to first order.
  struct PressureStep
  {
    Eigen::Vector3d now;
    Eigen::Matrix<double, 3, ElementUnknowns> byUnknown;
  };

  ElementVector gather(const Element& element, const Vector& u) const;
  double energyOf(const Element& element, const ElementVector& u, double* leastVolume) const;
  /// Linearizes one element. `followed` is the pressure after the last step; null if there was no
  /// step.
  void linearize(const Element& element, const ElementVector& u, const Eigen::Vector3d* followed,
    ElementVector& gradient, ElementMatrix& tangent, PressureStep& step) const;
  Eigen::Vector2d displacementAt(const SurfacePoint& point, const Vector& u) const;
  Gap gapAt(const SurfacePoint& point, const Eigen::Vector2d& displacement, double depth) const;
  void addContact(std::size_t p, Vector& gradient);
  int unknownOf(const Element& element, int i) const;
  void makePattern();

  const ToolOutline& Tool;
  bool IsLinear = false;
  double Penalty = 0.0; ///< MPa/mm
  std::vector<Material> Materials;
  std::vector<Element> Elements;
  std::vector<SurfacePoint> Surface;
  /// Index of u_r and u_z of each node; -1 if the displacement is fixed.
  std::vector<int> UnknownOf;
  Eigen::Index Unknowns = 0;
  Matrix Tangent;
  // The pressures of elements and of contact are separate unknowns, which are eliminated in each
  // step. If they were instead computed from the current volume change or gap, the tangent would
  // differ greatly from the tangent at the solution while the body is not in equilibrium.
  std::vector<Eigen::Vector3d> Pressures; ///< empty if they must be computed from the displacements
  std::vector<double> ContactPressures;   ///< MPa, < 0
  std::vector<PressureStep> Steps;
  std::vector<Gap> Gaps;
  /// Index in the tangent for each entry (row, column <= row) of each element; -1 if the entry
  /// belongs to a fixed displacement.
  std::vector<int> ValueOf;
};
} // namespace palpate

#endif
