// SPDX-License-Identifier: BSD-3-Clause
// Private parts of vtkHapticSession.
#ifndef HapticSessionState_h
#define HapticSessionState_h

#include "Interaction/Session/BodyKernels.h"
#include "Interaction/Session/SessionRun.h"
#include "vtkHapticSession.h"

#include <memory>
#include <vector>

/// The kernels and peaks of the session's body. They are valid while the body is unchanged.
struct vtkHapticSession::Kernels : palpate::BodyKernels
{
  vtkPolyData* body = nullptr;
  vtkMTimeType time = 0;
  bool given = false; ///< whether the caller passed the kernels that the next Start uses
};

/// The data of a hand to which the forces are fitted.
struct vtkHapticSession::Hand
{
  palpate::SafetySettings safety;
  double scale = 1.0; ///< scale of the workspace mapping
};

/// The state of the session from one Start to the next.
struct vtkHapticSession::Started
{
  std::vector<Hand> hands;
  std::shared_ptr<palpate::SessionRun> run;
};

#endif
