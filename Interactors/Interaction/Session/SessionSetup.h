// SPDX-License-Identifier: BSD-3-Clause
#ifndef SessionSetup_h
#define SessionSetup_h

#include "Contact/ContactSettings.h"
#include "Haptics/Devices/RecordedSetup.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// The setup of a session: tool, model and layers as the body stores them with the response `name`.
RecordedSetup setupOf(vtkPolyData* body, const std::string& name, const std::string& bodyName,
  const std::string& material, const FrictionSettings& friction);
} // namespace palpate

#endif
