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
  /// Depth δ at which the curve is evaluated, mm; negative if there is no contact.
  double depth = 0.0;
  /// -∇δ is ownNormal times the normal of the contact's own face, plus otherNormals.
  double ownNormal = 1.0;
  Vector3 otherNormals = Vector3::Zero();
  Jet share; ///< factor of the work at that depth
  /// The triangle on the other side of a blunt edge if the face of that triangle is nearer; else
  /// -1.
  std::int32_t nearerAcross = -1;
};

/// State of a tool within one tick: first its contact point, then its depth.
struct Pressed
{
  /// The contact point. Once the depth is known, the gradients of the area coordinates are those
  /// with respect to the tip's position.
  ContactTracker::Result found = {};
  bool isNew = false; ///< whether the whole body was searched
  double sunk = 0.0;  ///< depth of the followed point minus the depth by which the tool presses, mm
  ContactReach reach = {};
  bool isAtEdges = false;  ///< whether sharp or blunt edges have an effect
  bool isAtBorder = false; ///< whether the tip is beyond an open border

  ContactPlace& place() noexcept { return this->found.place; }
  const ContactPlace& place() const noexcept { return this->found.place; }
  /// Returns whether the tool presses. At edges a contact begins when the depth exceeds 0;
  /// elsewhere it begins at depth 0.
  bool presses() const noexcept
  {
    const double depth = this->reach.depth;
    return this->reach.share.value > 0.0 && (this->isAtEdges ? depth > 0.0 : !(depth < 0.0));
  }
};
} // namespace palpate

#endif
