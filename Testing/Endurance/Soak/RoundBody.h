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

/// What shape and how stiff.
struct BodyForm
{
  Vector3 centre = Vector3::Zero();             ///< mm
  Vector3 halfAxes = Vector3(50.0, 50.0, 50.0); ///< mm
  double bumps = 0.0;                           ///< height, mm, of gentle waves
  double modulus = 0.1;                         ///< reduced, E*, MPa
  double variation = 0.0;                       ///< of the modulus from point to point, relative
};

/**
 * A nearly round, triangulated body with a modulus at each point, and where a tip touches it: found
 * among all triangles, anew for each tip, by nothing but the distance.
 *
 * The bodies are gentle (no edge sharper than some 0.2 rad) and touched a few mm deep, so that the
 * contact a tick follows is the nearest point of all, and the only question is which of two
 * equally near ones it is: then both are told.
 */
class RoundBody
{
public:
  /// 20·4^times triangles.
  RoundBody(const BodyForm& form, int times);

  /// A nearest point.
  struct Touch
  {
    double depth = 0.0;               ///< below the surface, mm; negative above it
    Vector3 normal = Vector3::Zero(); ///< the three point normals blended, unit
    double modulus = 0.0;             ///< likewise, MPa
  };
  /// All that are as near as the nearest to within NearestTolerance; at least one.
  std::vector<Touch> touch(const Vector3& tip) const;
  /// mm; the kernel keeps coordinates as float32 about the centre of the body: 2^-25 of 64 mm in
  /// each, so 7e-6 mm between two distances at most.
  static constexpr double NearestTolerance = 2e-5;
  /// Of one depth, likewise.
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
  /// Of each triangle: a sphere around it, for what cannot be near.
  std::vector<Vector3> Middles;
  std::vector<double> Radii;
};
} // namespace palpate::endurance

#endif
