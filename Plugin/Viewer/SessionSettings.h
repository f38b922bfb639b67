// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SessionSettings_h
#define palpate_SessionSettings_h

#include "TouchScene.h"
#include "ViewerOptions.h"

#include <string>

class vtkHapticSession;

namespace palpate
{
/// Gives the session what the options say of forces, surface and friction, and the scene's
/// Poisson's ratio.
void chooseContact(
  const ViewerOptions& options, const TouchScene& scene, vtkHapticSession* session);

/// The friction in words for the summary, "mu = 0.5, ..."; "" without.
std::string describeFriction(const ViewerOptions& options, const TouchScene& scene);
} // namespace palpate

#endif
