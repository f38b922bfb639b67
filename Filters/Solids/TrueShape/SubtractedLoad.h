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
  std::int32_t point = 0;   ///< index of the surface point X
  Eigen::Matrix3d frame;    ///< columns: two tangents and the inward normal at X
  Eigen::Vector3d origin;   ///< position of X, mm
  ElasticMaterial material; ///< material at X, which is that of the half-space

  SingularSource(const ElasticBody& body, std::int32_t surfacePoint);
  Eigen::Vector3d inFrame(const Eigen::Vector3d& place) const
  {
    return this->frame.transpose() * (place - this->origin);
  }
  /// Returns whether the singular field is used at a position in the frame. It is used outside a
  /// cone of 41° around the singular line of the field.
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
 * The first integral is over the outer faces (it is zero on the plane through X). The second
 * integral is over the elements of another material. The incompatible modes of hexahedra contribute
 * to the second integral and are condensed as in the stiffness. They do not contribute to the first
 * integral.
 *
 * u_B has a singular line above X. If the body overhangs X (a mouth, an ear), u_B is used only
 * outside a cone around the singular line. In the elements that cross the cone, u_B is interpolated
 * between the nodes, with zero inside the cone.
 *
 * One object is used for one body. load() is thread-safe.
 */
class SubtractedLoad
{
public:
  /// The body must be assembled and must outlive this object.
  explicit SubtractedLoad(const ElasticBody& body);

  /// Returns b at the unknowns, including the effect of the held displacements.
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
  std::vector<std::int32_t> LoadedFaces;          ///< outer faces that are not entirely held
  std::vector<std::pair<std::int32_t, int>> Held; ///< node and axis of each column of Coupling
  /// Stiffness between unknowns and held directions.
  Eigen::SparseMatrix<double> Coupling;
};

/// Returns w at every node, mm. `smooth` contains w at the unknowns.
Eigen::Matrix3Xd regularDisplacement(
  const ElasticBody& body, const SingularSource& source, const Eigen::VectorXd& smooth);
} // namespace palpate

#endif
