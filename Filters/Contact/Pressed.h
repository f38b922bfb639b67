// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Pressed_h
#define palpate_Pressed_h

#include "Contact/ContactTracker.h"
#include "Contact/Jet.h"

#include <cstdint>

namespace palpate
{
/// Depth of a pressed tool, and the factor by which edges and borders change its work. All values
/// are functions of the tip's position alone.
struct ContactReach
{
  double depth = 0.0; ///< δ at which the curve is evaluated, mm; < 0: no contact
  /// -∇δ = ownNormal times the normal of the contact's own face, plus otherNormals.
  double ownNormal = 1.0;
  Vector3 otherNormals = Vector3::Zero();
  Jet share; ///< the factor of the work at that depth
  /// The triangle on the other side of a blunt edge if its face is nearer; else -1.
  std::int32_t nearerAcross = -1;
};

/// State of a tool within one tick: first its contact point, then its depth.
struct Pressed
{
  /// The contact. Once the depth is known, the gradients of the area coordinates are those by the
  /// position of the tip.
  ContactTracker::Result found = {};
  bool isNew = false; ///< the whole body was searched
  double sunk = 0.0;  ///< depth of the followed point minus the depth by which the tool presses, mm
  ContactReach reach = {};
  bool isAtEdges = false;  ///< sharp or blunt edges have an effect
  bool isAtBorder = false; ///< beyond an open border

  ContactPlace& place() noexcept { return this->found.place; }
  const ContactPlace& place() const noexcept { return this->found.place; }
  /// Whether the tool presses. A contact at edges begins above depth 0, others at depth 0.
  bool presses() const noexcept
  {
    const double depth = this->reach.depth;
    return this->reach.share.value > 0.0 && (this->isAtEdges ? depth > 0.0 : !(depth < 0.0));
  }
};
} // namespace palpate

#endif
