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
 * What a body adds to the half-space under an axisymmetric contact of radius a, whatever the tool:
 * the regular part of the Green function, averaged over the angles of both points,
 *   H₀(r, ρ) = Σ c_mn (r/a)^{2m} (ρ/a)^{2n},  m, n < order,
 * and how the surface falls off under it.
 */
struct ContactKernel
{
  static constexpr int LargestOrder = 4;

  int order = 0; ///< N; 0: there is none
  /// c, mm/N, symmetric; zero beyond the order.
  Eigen::Matrix4d coefficients = Eigen::Matrix4d::Zero();
  /// β = ∇_s H₀ at X, 1/N, in the tangent frame: how the surface turns under 1 N.
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
  /// The mean of the surface's normals that c₀₀ belongs to, outward; shorter than 1 on a curved
  /// one.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double spread = 0.0; ///< what is open of c₀₀ between the places it is known at, mm/N
  GapTerms gap;
};

/// What the elements miss of c₀₀, mm/N, by contact radius, where a second mesh tells it
/// (MeshDifference).
struct PALPATE_EXPORT MissedCompliance
{
  std::vector<double> radii;  ///< ascending, mm
  std::vector<double> values; ///< beside them; empty: not told

  bool isKnown() const { return !this->values.empty(); }
  /// Linear in ln a; beyond the radii as at the last one.
  double at(double radius) const;
  /// What it and another estimate, >= 0, that knows nothing of it, tell together: the root of the
  /// harmonic mean of their squares, which the lesser of both weighs most in, but not by more than
  /// √2: either may be nothing by chance, or far too much.
  double beside(double expected, double radius) const;
};

/// A point of a body, as its kernels are known there.
struct KernelSite
{
  PatchStatus status = PatchStatus::Degenerate;
  ElasticMaterial material;
  double reducedModulus = 0.0; ///< MPa
  double limit = Infinity;     ///< mm to the nearest edge, held point or other material
  PatchStatus limitedBy = PatchStatus::Valid; ///< which of them it is, where that ends contacts
  double toHeld = Infinity;                   ///< mm to where what is held begins (HeldRim)
  double largestRadius = 0.0; ///< of a contact, mm: what was solved for, or up to `limit`
  double nearestSource = 0.0; ///< mm
  double spacing = 0.0;       ///< of the elements' nodes, mm
  /// Γ around the point, in the tangent frame, mm/N: how it yields by the direction of the force
  /// (DirectedCompliance), less Boussinesq's field.
  Eigen::Matrix3d directed = Eigen::Matrix3d::Zero();
  ExpectedError elements;
  MissedCompliance missed; ///< where it is known, beside `elements`
};

/// Kernels of contacts at one point, of any radius.
class PALPATE_EXPORT ContactKernels
{
public:
  virtual ~ContactKernels() = default;

  /// Where a pointed tool's curve begins, over the largest contact: below it the law is a power.
  static constexpr double FirstRadius = 1.0 / 40.0;

  const KernelSite& site() const { return this->Site; }
  void setMissed(MissedCompliance missed) { this->Site.missed = std::move(missed); }

  /// The kernel of the largest order that is known, but not above `largestOrder` >= 1. Of order 0
  /// where the site is not valid, or for a radius that is none.
  virtual ContactKernel at(double radius, int largestOrder = ContactKernel::LargestOrder) const = 0;

  /// The surface around the point, where its shape is known beyond the angle mean; or null.
  virtual const SurfaceGap* surface() const { return nullptr; }

protected:
  ContactKernels() = default;
  ContactKernels(const ContactKernels&) = default;
  ContactKernels& operator=(const ContactKernels&) = default;

  KernelSite Site;
};
} // namespace palpate

#endif
