// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactKernels_h
#define palpate_ContactKernels_h

#include "Mechanics/PalpateExport.h"
#include "Solids/TrueShape/RegularGreen.h"
#include "Solids/TrueShape/SurfaceGap.h"

#include <utility>
#include <vector>

namespace palpate
{
/**
 * Difference between a body and the half-space under an axisymmetric contact of radius a, for any
 * tool: the regular part of the Green function, averaged over the angles of both points,
 *   H₀(r, ρ) = Σ c_mn (r/a)^{2m} (ρ/a)^{2n},  m, n < order,
 * and the drop of the surface under the contact.
 */
struct ContactKernel
{
  static constexpr int LargestOrder = 4;

  int order = 0; ///< N; 0: no kernel
  /// c, mm/N, symmetric; zero beyond the order.
  Eigen::Matrix4d coefficients = Eigen::Matrix4d::Zero();
  /// β = ∇_s H₀ at X, 1/N, in the tangent frame: the tilt of the surface under 1 N.
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  /// Mean of the outward surface normals to which c₀₀ refers. It is shorter than 1 on a curved
  /// surface.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double spread = 0.0; ///< uncertainty of c₀₀ from the interpolation between known places, mm/N
  GapTerms gap;
};

/// Error of c₀₀ due to the elements, mm/N, as a function of the contact radius, estimated from a
/// second mesh (MeshDifference).
struct PALPATE_EXPORT MissedCompliance
{
  std::vector<double> radii;  ///< ascending, mm
  std::vector<double> values; ///< one per radius; empty: unknown

  bool isKnown() const { return !this->values.empty(); }
  /// The value at a radius, linear in ln a. Beyond the radii it is the value of the nearest radius.
  double at(double radius) const;
  /// This error combined with another, independent estimate `expected` >= 0: the root of the
  /// harmonic mean of the two squares. The smaller estimate dominates, and the result is at most √2
  /// times the smaller one. This is used because either estimate may be zero by chance, or far too
  /// large.
  double beside(double expected, double radius) const;
};

/// A point of a body with the data that its kernels need.
struct KernelSite
{
  PatchStatus status = PatchStatus::Degenerate;
  ElasticMaterial material;
  double reducedModulus = 0.0; ///< MPa
  double limit = Infinity;     ///< distance to the nearest edge, held point or other material, mm
  PatchStatus limitedBy = PatchStatus::Valid; ///< the kind of `limit`, if it ends contacts
  double toHeld = Infinity; ///< distance to the edge of the held surface, mm (HeldRim)
  /// Largest contact radius, mm: the radius that was solved for, or `limit` if that is smaller.
  double largestRadius = 0.0;
  double nearestSource = 0.0; ///< distance to the nearest source, mm
  double spacing = 0.0;       ///< spacing of the elements' nodes, mm
  /// Γ around the point, in the tangent frame, mm/N: the compliance by direction of the force
  /// (DirectedCompliance), without Boussinesq's field.
  Eigen::Matrix3d directed = Eigen::Matrix3d::Zero();
  ExpectedError elements;
  MissedCompliance missed; ///< error from a second mesh, if known, in addition to `elements`
};

/// Kernels of contacts at one point, of any radius.
class PALPATE_EXPORT ContactKernels
{
public:
  virtual ~ContactKernels() = default;

  /// Ratio of the radius of the first contact on the curve of a pointed tool to the largest contact
  /// radius. Below that radius the law is a power of δ.
  static constexpr double FirstRadius = 1.0 / 40.0;

  const KernelSite& site() const { return this->Site; }
  void setMissed(MissedCompliance missed) { this->Site.missed = std::move(missed); }

  /// The kernel of the largest known order, limited to `largestOrder` >= 1. The order is 0 if the
  /// site or the radius is not valid.
  virtual ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const = 0;

  /// The surface around the point if its shape is known beyond the angle mean, else null.
  virtual const SurfaceGap* surface() const { return nullptr; }

protected:
  ContactKernels() = default;
  ContactKernels(const ContactKernels&) = default;
  ContactKernels& operator=(const ContactKernels&) = default;

  KernelSite Site;
};
} // namespace palpate

#endif
