// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SessionSettings_h
#define palpate_SessionSettings_h

#include "ResponseSet.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

class vtkHapticSession;

namespace palpate
{
/// Gives the session the options of forces, surface and friction, and the scene's Poisson's ratio.
void chooseContact(
  const ViewerOptions& options, const ViewerScene& scene, vtkHapticSession* session);

/// Gives the session the device of the options. Returns an error, or "".
std::string openDevice(const ViewerOptions& options, vtkHapticSession* session);

/// The same, with one force factor for all responses, so that their ratios are kept. Returns an
/// error, or "".
std::string chooseDevice(
  const ViewerOptions& options, const ResponseSet& responses, vtkHapticSession* session);

/// Adds the further devices of the options. Returns an error, or "".
std::string addHands(const ViewerOptions& options, vtkHapticSession* session);

/// Places physical devices in view: the origin above the first site, those of further ones beside
/// it, x to the right and y up in the picture; the first button is the clutch.
void placeDevice(const ViewerScene& scene, const ResponseSet& responses, vtkHapticSession* session);

/// Starts the session; returns the error it reported, or "".
std::string startQuietly(vtkHapticSession* session);

/// The friction in words for the summary, "mu = 0.5, ..."; "" without.
std::string describeFriction(const ViewerOptions& options, const ViewerScene& scene);
} // namespace palpate

#endif
