// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TouchGoal_h
#define palpate_TouchGoal_h

#include "Contact/ContactBody.h"

#include <array>
#include <cstdint>

namespace palpate
{
/// A place of a body where a hand holds the tip, and a way there from outside. Body frame, mm.
struct TouchGoal
{
  static constexpr std::size_t MostSteps = 8;

  TouchGoal() noexcept { this->way.fill(Vector3::Zero()); }

  std::uint64_t number = 0;          ///< rises from goal to goal; 0: there is no goal
  std::uint64_t bodyNumber = 0;      ///< rises from body to body
  std::uint64_t surface = 0;         ///< equal for bodies with equal triangles
  const ContactBody* body = nullptr; ///< must exist until a hand has a goal on another body
  Vector3 point = Vector3::Zero();   ///< point on the surface
  Vector3 normal = Vector3::Zero();  ///< unit, outward
  std::int32_t triangle = -1;        ///< triangle of the point, in the body's mesh
  double height = 0.0; ///< height of the tip above the point; negative: the tip presses
  double hover = 0.0;  ///< height up to which the column over the point is free
  double margin = 0.0; ///< clearance to keep on the way

  /// The way, from the top of the column outwards. It is free.
  std::array<Vector3, MostSteps> way;
  std::size_t steps = 0;            ///< points of the way, at least 1
  bool leadsOut = false;            ///< whether the last point is on the sphere below
  Vector3 centre = Vector3::Zero(); ///< centre of a sphere around the body
  double radius = 0.0;

  Vector3 tip() const noexcept { return this->point + this->height * this->normal; }
  bool presses() const noexcept { return this->height < 0.0; }
};
} // namespace palpate

#endif
