// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContactReading_h
#define ContactReading_h

#include "Interaction/Display/ShownContact.h"

class vtkHapticSession;
class vtkPolyData;

namespace palpate
{
/// Tip `index` of the output of vtkToolContactProbe or vtkHapticRecorder::GetRecording.
/// FrictionForce, ContactState, AppliedForce and its SafetyLinks are read where they are; false if
/// any other array is missing or there is no such tip.
bool readTip(vtkPolyData* probed, vtkIdType index, ShownContact& contact);

/// The newest tick of a session, all of the same tick. A session that does not run, and a device
/// without force, apply none that could be shown.
ShownContact readSession(vtkHapticSession* session);
} // namespace palpate

#endif
