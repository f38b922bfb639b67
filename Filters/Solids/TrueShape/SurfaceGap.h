// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceGap_h
#define palpate_SurfaceGap_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <array>

namespace palpate
{
/// A surface under a contact of radius a, in the tangent plane: r from the point, θ around it.
struct GapTerms
{
  /// Angle mean of how far it lies below the plane, Σ d_m (r/a)^{2m}, mm.
  Eigen::Vector4d drop = Eigen::Vector4d::Zero();
  /// Which way it leans as the contact feels it: the slope of a plane with the same moment.
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();
  /// Σ g_m(a)² of the harmonics from the second on, mm² (SurfaceGap).
  double waves = 0.0;
  /// Mean square under the contact of what all these leave, mm².
  double left = 0.0;
  /// How far its facets lie off the surface, which is smooth between its points, mm: the root of
  /// the mean square under the contact.
  double facets = 0.0;
  /// How far the edges of its triangles are from arcs, likewise: (n₁ + n₂)·e of an edge e between
  /// two normals, κ'l³/6 if its curvature changes by κ' per mm. It tells a surface that its points
  /// describe from one that goes on between them.
  double uneven = 0.0;
};

/**
 * How a surface falls off around a point, whatever its shape: its heights on rings, in harmonics of
 * the angle.
 *
 * To first order a contact of radius a feels the mean of the gap weighted by 1/√(a² - r²), to
 * second order its harmonics: the energy of a gap h_m(r) cos mθ that is closed over the contact is
 *   ½ E* ∫_0^a g_m(x)² dx,  g_m(x) = x^{-m} d/dx ∫_0^x r^{m+1} h_m / √(x² - r²) dr
 * (Copson 1947), and since the pressure ends smoothly, that is all there is to second order: the
 * force at a depth grows by ½ E* Σ g_m(a)² da/dδ. Exact for a plane that leans (h = s r, g = 2 s x)
 * and for unequal curvatures (Hertz 1882: the force of the mean one times 1 + Δ²R²/12).
 */
class PALPATE_EXPORT SurfaceGap
{
public:
  static constexpr int Rings = 19;
  static constexpr int Angles = 16;

  /// How far the surface is to be known, for contacts up to a radius: three rings more, since on an
  /// uneven surface they reach beyond those on the mean of it.
  static double reachFor(double radius);

  /// The tangent plane's axes and the inward normal, in which heights and slopes are told.
  static Eigen::Matrix3d frame(const Eigen::Vector3d& outwardNormal);

  /// Radius of ring k, over that of the last.
  static double ring(int k);

  /// Heights below the tangent plane, mm, at angles 2π j/Angles of each ring: of the surface, and
  /// of its facets; and how uneven the edges are there. Rings beyond `known` are not used.
  struct Heights
  {
    Eigen::Matrix<double, Rings, Angles> surface;
    Eigen::Matrix<double, Rings, Angles> facets;
    Eigen::Matrix<double, Rings, Angles> uneven = Eigen::Matrix<double, Rings, Angles>::Zero();
    int known = Rings;
  };

  /// A plane.
  SurfaceGap() = default;
  /// `radius` of the last ring, mm.
  SurfaceGap(double radius, const Heights& heights);

  /// How far from the point the surface is known, mm, and whether that is as far as was asked for.
  double reach() const;
  bool isWhole() const { return this->Known == Rings || this->Radius == 0.0; }

  /// Under a contact of radius a, mm; of one beyond reach() as far as it is known.
  GapTerms at(double a) const;

  /// Heights below the tangent plane within reach(), mm: in harmonics of the angle, straight in r²
  /// from ring to ring.
  class PALPATE_EXPORT Spectrum
  {
  public:
    explicit Spectrum(const SurfaceGap& gap);
    /// The angle mean at a distance of the point.
    double mean(double r) const;
    /// What the surface lies below that at a place.
    double around(const Eigen::Vector2d& place) const;

  private:
    struct Between
    {
      int low; ///< the same ring as `high` inside the first
      int high;
      double part;
    };
    Between between(double r) const;
    double amplitude(int i, const Between& rings) const;

    double Radius;
    int Known;
    Eigen::Matrix<double, Angles, Rings> Amplitudes; ///< 1, cos θ, sin θ, cos 2θ, ... cos 8θ
  };

  /// Where the height of a ring and an angle is told, mm.
  Eigen::Vector2d place(int k, int j) const;

private:
  static constexpr int Harmonics = 4;

  double Radius = 0.0;
  int Known = 0;
  Eigen::Matrix<double, Rings, Angles> Surface = Eigen::Matrix<double, Rings, Angles>::Zero();
  std::array<double, Rings> Mean{};
  std::array<double, Rings> Between{}; ///< mean square of surface less facets
  std::array<double, Rings> Uneven{};  ///< mean square
  std::array<double, Rings> Left{};    ///< mean square of the harmonics beyond
  /// Of harmonics 1, 2, ...: cosine and sine.
  std::array<std::array<Eigen::Vector2d, Rings>, Harmonics> Waves;
};
} // namespace palpate

#endif
