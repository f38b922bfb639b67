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
 * tool. It consists of the regular part of the Green function, averaged over the angles of both
 * points,
 *   H₀(r, ρ) = Σ c_mn (r/a)^{2m} (ρ/a)^{2n},  m, n < order,
 * and the drop of the surface under the contact.
 */
struct ContactKernel
{
  static constexpr int LargestOrder = 4;

  int order = 0; ///< order N; 0 means that there is no kernel
  /// The coefficients c, mm/N. The matrix is symmetric. Entries beyond the order are zero.
  Eigen::Matrix4d coefficients = Eigen::Matrix4d::Zero();
  /// The tilt of the surface under 1 N, β = ∇_s H₀ at X, 1/N, in the tangent frame.
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  /// Mean of the outward surface normals to which c₀₀ refers. Its length is less than 1 on a curved
  /// surface.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  /// Uncertainty of c₀₀ due to the interpolation between known positions, mm/N.
  double spread = 0.0;
  GapTerms gap;
};

/// Error of c₀₀ due to the elements, mm/N, as a function of the contact radius. It is estimated
/// from a second mesh (MeshDifference).
struct PALPATE_EXPORT MissedCompliance
{
  std::vector<double> radii;  ///< contact radii in ascending order, mm
  std::vector<double> values; ///< one error per radius; empty if the error is unknown

  bool isKnown() const { return !this->values.empty(); }
  /// Returns the error at a radius, interpolated linearly in ln a. Beyond the given radii, returns
  /// the error of the nearest radius.
  double at(double radius) const;
  /// Combines this error with another, independent estimate `expected` >= 0. Returns the root of
  /// the harmonic mean of the two squares. The smaller estimate dominates, and the result is at
  /// most √2 times the smaller estimate. This mean is used because either estimate may be zero by
  /// chance, or far too large.
  double beside(double expected, double radius) const;
};

/// A point of a body, with the data that the kernels at this point need.
struct KernelSite
{
  PatchStatus status = PatchStatus::Degenerate;
  ElasticMaterial material;
  double reducedModulus = 0.0; ///< MPa
  double limit = Infinity;     ///< distance to the nearest edge, held point or other material, mm
  PatchStatus limitedBy = PatchStatus::Valid; ///< kind of the limit, if the limit ends contacts
  double toHeld = Infinity; ///< distance to the edge of the held part of the surface, mm (HeldRim)
  /// Largest contact radius, mm. It is the radius for which the body was solved, or `limit` if that
  /// is smaller.
  double largestRadius = 0.0;
  double nearestSource = 0.0; ///< distance to the nearest source, mm
  double spacing = 0.0;       ///< distance of neighbouring nodes of the elements, mm
  /// Γ around the point, in the tangent frame, mm/N. It is the compliance as a function of the
  /// direction of the force (DirectedCompliance), without Boussinesq's field.
  Eigen::Matrix3d directed = Eigen::Matrix3d::Zero();
  ExpectedError elements;
  MissedCompliance missed; ///< error from a second mesh, if known; it complements `elements`
};

/// Kernels at one point for contacts of any radius.
class PALPATE_EXPORT ContactKernels
{
public:
  virtual ~ContactKernels() = default;

  /// Ratio of the radius of the first contact on the curve of a pointed tool to the largest contact
  /// radius. Below this first radius, the law is a power of δ.
  static constexpr double FirstRadius = 1.0 / 40.0;

  const KernelSite& site() const { return this->Site; }
  void setMissed(MissedCompliance missed) { this->Site.missed = std::move(missed); }

  /// Returns the kernel of the largest known order, limited to `largestOrder` >= 1. The order is 0
  /// if the site or the radius is not valid.
  virtual ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const = 0;

  /// Returns the surface around the point if its shape is known in more detail than its mean over
  /// angles. Otherwise returns null.
  virtual const SurfaceGap* surface() const { return nullptr; }

protected:
  ContactKernels() = default;
  ContactKernels(const ContactKernels&) = default;
  ContactKernels& operator=(const ContactKernels&) = default;

  KernelSite Site;
};
} // namespace palpate

#endif
