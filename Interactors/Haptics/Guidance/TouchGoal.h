// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TouchGoal_h
#define palpate_TouchGoal_h

#include "Contact/ContactBody.h"

#include <array>
#include <cstdint>

namespace palpate
{
/// A point on a body, the position of a tip at this point, and a path to it from outside the body.
/// Body frame, mm.
struct TouchGoal
{
  static constexpr std::size_t MostSteps = 8;

  TouchGoal() noexcept { this->way.fill(Vector3::Zero()); }

  std::uint64_t number = 0;          ///< increases from goal to goal; 0 if there is no goal
  std::uint64_t bodyNumber = 0;      ///< increases from body to body
  std::uint64_t surface = 0;         ///< equal for bodies with equal triangles
  const ContactBody* body = nullptr; ///< must exist until all hands have goals on other bodies
  Vector3 point = Vector3::Zero();   ///< point on the surface
  Vector3 normal = Vector3::Zero();  ///< unit, outward
  std::int32_t triangle = -1;        ///< triangle of the point, in the body's mesh
  double height = 0.0; ///< height of the tip above the point; negative: the tip presses
  double hover = 0.0;  ///< height up to which the column over the point is free
  double margin = 0.0; ///< clearance to keep along the path, mm

  /// The free path from the top of the column outwards.
  std::array<Vector3, MostSteps> way;
  std::size_t steps = 0;            ///< number of points of the path, at least 1
  bool leadsOut = false;            ///< whether the last point is on the sphere around the body
  Vector3 centre = Vector3::Zero(); ///< centre of a sphere around the body
  double radius = 0.0;

  Vector3 tip() const noexcept { return this->point + this->height * this->normal; }
  bool presses() const noexcept { return this->height < 0.0; }
};
} // namespace palpate

#endif
