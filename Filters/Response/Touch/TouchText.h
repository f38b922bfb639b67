// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchText_h
#define TouchText_h

#include "Response/Touch/TouchedBody.h"

#include <string>

namespace palpate
{
/// One touch, as vtkToolTouch shows it. Body frame; mm, N.
struct Touch
{
  Vector3 tip = Vector3::Zero();     ///< after snap and indentation
  TouchedPlace nearest;              ///< of the tip as it was given
  TouchedPlace place;                ///< the contact; cell -1: none
  Vector3 normal = Vector3::UnitZ(); ///< of the contact; without one, away from the surface
  Vector3 force = Vector3::Zero();
  int state = 0; ///< vtkToolContactProbe's ContactState
  double deflection = 0.0;
  double stiffness = 0.0; ///< N/mm
  double range = 0.0;     ///< of the response there
  double scale = 0.0;     ///< mm/N of the arrow
  PlaceValidity validity;

  bool touches() const { return this->place.cell >= 0; }
};

/// Its numbers in plain words, with units, one line each.
std::string describeTouch(const Touch& touch, const std::string& tool);
} // namespace palpate

#endif
