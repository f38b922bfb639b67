// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SubtractedLoad_h
#define palpate_SubtractedLoad_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/TrueShape/BoussinesqField.h"

#include <Eigen/SparseCore>

namespace palpate
{
/// A force of 1 N at a surface point X, and the half-space on which it is assumed to act.
struct SingularSource
{
  std::int32_t point = 0;   ///< surface point
  Eigen::Matrix3d frame;    ///< columns: two tangents and the inward normal at X
  Eigen::Vector3d origin;   ///< X, mm
  ElasticMaterial material; ///< material at X

  SingularSource(const ElasticBody& body, std::int32_t surfacePoint);
  Eigen::Vector3d inFrame(const Eigen::Vector3d& place) const
  {
    return this->frame.transpose() * (place - this->origin);
  }
  /// Whether the singular field is used at a place in the frame: outside a cone of 41° around its
  /// singular line.
  static bool isUnder(const Eigen::Vector3d& at) { return at[2] > -LargestOverhang * at.norm(); }

  static constexpr double LargestOverhang = 0.75;
};

/**
 * The load that remains for the elements of a body under 1 N at a surface point X after the
 * singular field is subtracted: u = u_B + w, where u_B is Boussinesq's field at X along the inward
 * normal, with the material at X.
 *
 * The remaining field w is smooth and solves K w = b with
 *   b(v) = -∮ v·(σ_B n) dA - ∫ ε(v) : (D - D₀) : ε_B dV,
 *   w = -u_B where the body is held.
 * The first integral is over the outer faces (zero on the plane through X), the second over the
 * elements of another material. The incompatible modes of hexahedra contribute to the second
 * integral and are condensed as in the stiffness; they have no part in the first.
 *
 * u_B has a singular line above X. If the body overhangs X (a mouth, an ear), u_B is used only
 * outside a cone around that line. In the elements that cross the cone it is interpolated between
 * the nodes, with zero inside the cone.
 *
 * One object is used for one body; load() may be called from any number of threads.
 */
class SubtractedLoad
{
public:
  /// The body must be assembled and must outlive this object.
  explicit SubtractedLoad(const ElasticBody& body);

  /// b at the unknowns, including the effect of the held displacements.
  Eigen::VectorXd load(const SingularSource& source) const;

private:
  struct Work;

  void couple();
  void addOuterFaces(Work& work) const;
  void addInclusions(Work& work) const;
  void addOverhang(Work& work) const;
  void addFace(std::int32_t element, int face, Work& work) const;

  const ElasticBody& Body;
  bool Uniform;                                   ///< whether the body has one material
  std::vector<std::int32_t> LoadedFaces;          ///< outer faces that are not held as a whole
  std::vector<std::pair<std::int32_t, int>> Held; ///< node and axis of each column of Coupling
  Eigen::SparseMatrix<double> Coupling;           ///< unknowns × held directions
};

/// w at every node, mm. `smooth`: w at the unknowns.
Eigen::Matrix3Xd regularDisplacement(
  const ElasticBody& body, const SingularSource& source, const Eigen::VectorXd& smooth);
} // namespace palpate

#endif
