// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceGap_h
#define palpate_SurfaceGap_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>

namespace palpate
{
/// Shape of a surface under a contact of radius a, in polar coordinates r, θ of the tangent plane
/// at the point.
struct GapTerms
{
  /// Mean over angles of the distance below the plane, Σ d_m (r/a)^{2m}, mm.
  Eigen::Vector4d drop = Eigen::Vector4d::Zero();
  /// Effective slope of the surface under the contact. It is the slope of a plane with the same
  /// moment.
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();
  /// Σ g_m(a)² of the harmonics of order 2 and above, mm² (SurfaceGap).
  double waves = 0.0;
  /// Mean square of the residual of these terms under the contact, mm².
  double left = 0.0;
  /// Root mean square distance, under the contact, between the facets and the surface, mm. The
  /// surface is assumed to be smooth between its points.
  double facets = 0.0;
  /// Root mean square, under the contact, of the deviation of the triangles' edges from arcs. The
  /// deviation is (n₁ + n₂)·e for an edge e between two normals, which is κ'l³/6 if the curvature
  /// changes by κ' per mm. A large value shows that the surface has unresolved detail between its
  /// points.
  double uneven = 0.0;
};

/**
 * Shape of any surface around a point. It is stored as the heights on rings, as harmonics of the
 * angle.
 *
 * To first order, a contact of radius a depends on the mean of the gap weighted by 1/√(a² - r²). To
 * second order, it depends on the harmonics of the gap. A gap h_m(r) cos mθ that is closed over the
 * contact has the energy
 *   ½ E* ∫_0^a g_m(x)² dx, g_m(x) = x^{-m} d/dx ∫_0^x r^{m+1} h_m / √(x² - r²) dr (Copson 1947).
 * Because the pressure falls smoothly to zero, there is no other term of second order, and the
 * force at a depth increases by ½ E* Σ g_m(a)² da/dδ. This is exact for an inclined plane (h = s r,
 * g = 2 s x) and for unequal curvatures (Hertz 1882: the force of the mean curvature times 1 +
 * Δ²R²/12).
 */
class PALPATE_EXPORT SurfaceGap
{
public:
  static constexpr int Rings = 19;
  static constexpr int Angles = 16;

  /// Returns the radius up to which the surface must be known for contacts up to `radius`. It
  /// includes three more rings, because on an uneven surface a contact extends beyond the contact
  /// on the mean surface.
  static double reachFor(double radius);

  /// Returns the axes of the tangent plane and the inward normal, which are the frame of heights
  /// and slopes.
  static Eigen::Matrix3d frame(const Eigen::Vector3d& outwardNormal);

  /// Returns the radius of ring k divided by the radius of the last ring.
  static double ring(int k);

  /// Heights below the tangent plane, mm, at the angles 2π j/Angles of each ring, for the surface
  /// and for its facets, and the unevenness of the edges at these positions. Rings beyond `known`
  /// are not used.
  struct Heights
  {
    Eigen::Matrix<double, Rings, Angles> surface;
    Eigen::Matrix<double, Rings, Angles> facets;
    Eigen::Matrix<double, Rings, Angles> uneven = Eigen::Matrix<double, Rings, Angles>::Zero();
    int known = Rings;
  };

  /// Creates the shape of a plane.
  SurfaceGap() = default;
  /// `radius` is the radius of the last ring, mm.
  SurfaceGap(double radius, const Heights& heights);

  /// reach() returns the radius up to which the surface is known, mm. isWhole() returns whether it
  /// is the requested radius.
  double reach() const;
  bool isWhole() const { return this->Known == Rings || this->Radius == 0.0; }

  /// Returns the terms of a contact of radius a, mm. If a exceeds reach(), the known part of the
  /// surface is used.
  GapTerms at(double a) const;

  /// Heights below the tangent plane within reach(), mm, as harmonics of the angle that are linear
  /// in r² between the rings.
  class PALPATE_EXPORT Spectrum
  {
  public:
    explicit Spectrum(const SurfaceGap& gap);
    /// Returns the mean over angles at a distance from the point.
    double mean(double r) const;
    /// Returns the height at a position below the mean over angles.
    double around(const Eigen::Vector2d& place) const;

  private:
    struct Between
    {
      int low; ///< the lower ring; equal to `high` inside the first ring
      int high;
      double part;
    };
    Between between(double r) const;
    double amplitude(int i, const Between& rings) const;

    double Radius;
    int Known;
    /// Amplitudes of 1, cos θ, sin θ, cos 2θ, ... cos 8θ
    Eigen::Matrix<double, Angles, Rings> Amplitudes;
  };

  /// Returns the position of the height at ring k and angle j, mm.
  Eigen::Vector2d place(int k, int j) const;

private:
  static constexpr int Harmonics = 4;

  double Radius = 0.0;
  int Known = 0;
  Eigen::Matrix<double, Rings, Angles> Surface = Eigen::Matrix<double, Rings, Angles>::Zero();
  std::array<double, Rings> Mean{};
  std::array<double, Rings> Between{}; ///< mean square of the distance between surface and facets
  std::array<double, Rings> Uneven{};  ///< mean square of the unevenness
  /// Mean square of the harmonics of higher order than those in Waves.
  std::array<double, Rings> Left{};
  /// Amplitudes of cosine and sine of the harmonics 1, 2, ...
  std::array<std::array<Eigen::Vector2d, Rings>, Harmonics> Waves;
};
} // namespace palpate

#endif
