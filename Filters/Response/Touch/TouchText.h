// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchText_h
#define TouchText_h

#include "Response/Touch/TouchedBody.h"
#include "Contact/Contact.h"

#include <string>

namespace palpate
{
/// One touch, as vtkToolTouch shows it. Body frame; mm, N.
struct Touch
{
  Vector3 tip = Vector3::Zero(); ///< after snap and indentation
  TouchedPlace nearest;          ///< of the tip as it was given
  TouchedPlace place;            ///< the contact; cell -1: none
  /// Without contact its normal leads away from the surface.
  Contact contact;
  double stiffness = 0.0; ///< of the stored curve, N/mm
  double range = 0.0;     ///< of the response there
  double scale = 0.0;     ///< mm/N of the arrow
  PlaceValidity validity;

  bool touches() const { return this->place.cell >= 0; }
};

/// Its numbers in plain words, with units, one line each.
std::string describeTouch(const Touch& touch, const std::string& tool);
} // namespace palpate

#endif
