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
/// Sets the contact settings of the options and the scene's Poisson's ratio in the session. Also
/// sets the names of body and material, for records.
void chooseContact(
  const ViewerOptions& options, const ViewerScene& scene, vtkHapticSession* session);

/// Opens the device of the options for the session. Returns "" or an error.
std::string openDevice(const ViewerOptions& options, vtkHapticSession* session);

/// Opens the device as openDevice does, and sets one force factor for all responses, so that the
/// ratios of their forces do not change. The factor is 1 for a hand that a mouse steers in real
/// time. Returns "" or an error.
std::string chooseDevice(
  const ViewerOptions& options, const ResponseSet& responses, vtkHapticSession* session);

/// Adds the further devices of the options. Returns "" or an error.
std::string addHands(const ViewerOptions& options, vtkHapticSession* session);

/// Sets the positions of physical devices in the view. The origin of the first device is above the
/// first site; the origins of the other devices are next to the first one. The x axis is to the
/// right and the y axis up in the picture. The first button is the clutch.
void placeDevice(const ViewerScene& scene, const ResponseSet& responses, vtkHapticSession* session);

/// Starts the session. Returns "" or the error that the session reported.
std::string startQuietly(vtkHapticSession* session);
} // namespace palpate

#endif
