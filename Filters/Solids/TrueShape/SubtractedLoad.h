// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SubtractedLoad_h
#define palpate_SubtractedLoad_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/TrueShape/BoussinesqField.h"

#include <Eigen/SparseCore>

namespace palpate
{
/// A force of 1 N at a surface point X, and the half-space it is thought to act on.
struct SingularSource
{
  std::int32_t point = 0;   ///< of the surface
  Eigen::Matrix3d frame;    ///< tangents and inward normal at X, columns
  Eigen::Vector3d origin;   ///< X, mm
  ElasticMaterial material; ///< at X

  SingularSource(const ElasticBody& body, std::int32_t surfacePoint);
  Eigen::Vector3d inFrame(const Eigen::Vector3d& place) const
  {
    return this->frame.transpose() * (place - this->origin);
  }
  /// Whether the singular field is used at a place in the frame: up to 41° from its singular line.
  static bool isUnder(const Eigen::Vector3d& at) { return at[2] > -LargestOverhang * at.norm(); }

  static constexpr double LargestOverhang = 0.75;
};

/**
 * What is left to the elements of a body under 1 N at a surface point X once the singular field is
 * subtracted: u = u_B + w, where u_B is Boussinesq's field at X along the inward normal, with the
 * material at X.
 *
 * w is smooth and solves K w = b, with
 *   b(v) = -∮ v·(σ_B n) dA - ∫ ε(v) : (D - D₀) : ε_B dV,   w = -u_B where the body is held;
 * the first over the outer faces (nothing on the plane through X), the second over the elements of
 * another material. The incompatible modes of hexahedra take their part of the second and are
 * condensed as in their stiffness; of the first they have none.
 *
 * u_B has a singular line above X. Where the body stands over itself (a mouth, an ear), u_B is used
 * up to a cone around that line only; in the elements that cross the cone it is interpolated
 * between nodes, with zero beyond.
 *
 * Made once for a body; load() may be called by any number of threads.
 */
class SubtractedLoad
{
public:
  /// The body, assembled, must stay.
  explicit SubtractedLoad(const ElasticBody& body);

  /// b, by unknowns, what the held displacements do included.
  Eigen::VectorXd load(const SingularSource& source) const;

private:
  struct Work;

  void couple();
  void addOuterFaces(Work& work) const;
  void addInclusions(Work& work) const;
  void addOverhang(Work& work) const;
  void addFace(std::int32_t element, int face, Work& work) const;

  const ElasticBody& Body;
  bool Uniform;                          ///< one material
  std::vector<std::int32_t> LoadedFaces; ///< of the boundary; the others are held as a whole
  std::vector<std::pair<std::int32_t, int>> Held; ///< node and axis of the columns of Coupling
  Eigen::SparseMatrix<double> Coupling;           ///< unknowns × held directions
};

/// w at every node, mm, of which `smooth` has the unknowns.
Eigen::Matrix3Xd regularDisplacement(
  const ElasticBody& body, const SingularSource& source, const Eigen::VectorXd& smooth);
} // namespace palpate

#endif
