// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SafetyFault_h
#define palpate_SafetyFault_h

#include "Contact/SettingFault.h"
#include "Mechanics/PalpateExport.h"
#include "Haptics/Safety/SafetySettings.h"

namespace palpate
{
/// The first of settings that come in from outside which is out of its range, NaN included, by its
/// name with a capital ("MaximumForce"). The chain itself is safe with any, but may send nothing.
PALPATE_EXPORT SettingFault faultOf(const SafetySettings& settings);

/// The range is that of SafetySettings::forceFactor and ServoScene::forceFactor.
PALPATE_EXPORT SettingFault faultOfForceFactor(double factor);
} // namespace palpate

#endif
