// SPDX-License-Identifier: BSD-3-Clause
#ifndef SessionSetup_h
#define SessionSetup_h

#include "Contact/ContactSettings.h"
#include "Haptics/Devices/RecordedSetup.h"
#include "palpateInteractionModule.h" // For export macro

#include <string>

class vtkPolyData;

namespace palpate
{
/// Describes a material: "E = 0.05 MPa, nu = 0.45".
PALPATEINTERACTION_EXPORT std::string materialInWords(double youngsModulus, double poissonRatio);

/// Describes the friction: "mu = 0.3, elasto-plastic, 1 N/mm", or "none" without friction.
PALPATEINTERACTION_EXPORT std::string frictionInWords(const FrictionSettings& friction);

/// Returns the setup of a session. Tool, model and layers are those that the body stores with the
/// response `name`.
RecordedSetup setupOf(vtkPolyData* body, const std::string& name, const std::string& bodyName,
  const std::string& material, const FrictionSettings& friction);
} // namespace palpate

#endif
