// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchText_h
#define TouchText_h

#include "Response/Touch/TouchedBody.h"
#include "Contact/Contact.h"

#include <string>
#include <vector>

namespace palpate
{
/// One touch, as vtkToolTouch displays it, in the body's frame (mm, N).
struct Touch
{
  Vector3 tip = Vector3::Zero(); ///< tip after snap and indentation
  TouchedPlace nearest;          ///< point of the body that is nearest to the given tip
  TouchedPlace place;            ///< place of the contact; the cell is -1 without contact
  /// The contact. If the tip does not touch, contact.normal points away from the surface.
  Contact contact;
  double stiffness = 0.0; ///< slope of the stored curve at the deflection, N/mm
  double range = 0.0;     ///< Range of the response at the place of the contact, mm
  double scale = 0.0;     ///< length of the arrow per unit of force, mm/N
  PlaceValidity validity;
  /// Distance by which the other tool lowers the surface at the place of the contact, mm.
  double sunk = 0.0;
  bool isAlone = false; ///< whether another tool presses and the response has no coupling

  bool touches() const { return this->place.cell >= 0; }
};

/// Returns the numbers of all touches as plain text with units, on several lines.
std::string describeTouches(const std::vector<Touch>& touches, const std::string& tool);
} // namespace palpate

#endif
