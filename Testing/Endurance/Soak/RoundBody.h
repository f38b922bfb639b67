// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_RoundBody_h
#define palpate_endurance_RoundBody_h

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace palpate::endurance
{
using Vector3 = Eigen::Vector3d;

/// Shape and stiffness of a body.
struct BodyForm
{
  Vector3 centre = Vector3::Zero();             ///< mm
  Vector3 halfAxes = Vector3(50.0, 50.0, 50.0); ///< mm
  double bumps = 0.0;                           ///< height of the waves, mm
  double modulus = 0.1;                         ///< reduced, E*, MPa
  double variation = 0.0; ///< relative variation of the modulus from point to point
};

/**
 * A nearly round, triangulated body with a modulus at each point. It finds the contact of a tip by
 * a search over all triangles. The search uses only the distance, and no data of earlier tips.
 * The bodies are smooth (no edge is sharper than about 0.2 rad) and the indentation is a few mm.
 * Therefore the contact that a tick follows is the global nearest point. Only two points at nearly
 * the same distance are ambiguous; then both are returned.
 */
class RoundBody
{
public:
  /// Makes a body of 20·4^times triangles.
  RoundBody(const BodyForm& form, int times);

  /// A nearest point.
  struct Touch
  {
    double depth = 0.0;               ///< depth below the surface, mm; negative above it
    Vector3 normal = Vector3::Zero(); ///< unit vector, interpolated from the three point normals
    double modulus = 0.0;             ///< interpolated in the same way, MPa
  };
  /// Returns all points whose distance exceeds the smallest distance by at most NearestTolerance;
  /// at least one point.
  std::vector<Touch> touch(const Vector3& tip) const;
  /// mm. The kernel stores coordinates as float32 relative to the centre of the body. Each
  /// coordinate has an error of 2^-25 of 64 mm, so the difference of two distances has an error of
  /// at most 7e-6 mm.
  static constexpr double NearestTolerance = 2e-5;
  /// Tolerance of a depth, mm, for the same reason.
  static constexpr double DepthTolerance = 1e-5;

  const std::vector<Vector3>& points() const { return this->Points; }
  const std::vector<Vector3>& normals() const { return this->Normals; }
  const std::vector<double>& moduli() const { return this->Moduli; }
  const std::vector<std::array<std::int32_t, 3>>& triangles() const { return this->Triangles; }

private:
  struct Foot
  {
    double distance = 0.0;
    Vector3 weights = Vector3::Zero();
    Vector3 point = Vector3::Zero();
  };
  Foot foot(const Vector3& tip, const std::array<std::int32_t, 3>& triangle) const;

  std::vector<Vector3> Points;
  std::vector<Vector3> Normals;
  std::vector<double> Moduli;
  std::vector<std::array<std::int32_t, 3>> Triangles;
  /// Bounding spheres of the triangles. They serve to skip triangles that cannot be near.
  std::vector<Vector3> Middles;
  std::vector<double> Radii;
};
} // namespace palpate::endurance

#endif
