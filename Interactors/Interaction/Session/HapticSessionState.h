// SPDX-License-Identifier: BSD-3-Clause
// The parts of vtkHapticSession that its header does not show.
#ifndef HapticSessionState_h
#define HapticSessionState_h

#include "Interaction/Session/BodyKernels.h"
#include "Interaction/Session/SessionRun.h"
#include "vtkHapticSession.h"

#include <memory>
#include <vector>

/// What was read of the body, per response, as long as it is the same.
struct vtkHapticSession::Kernels : palpate::BodyKernels
{
  vtkPolyData* body = nullptr;
  vtkMTimeType time = 0;
  bool given = false; ///< by the caller, for the next Start
};

/// What a scene is fitted to.
struct vtkHapticSession::Hand
{
  palpate::SafetySettings safety;
  double scale = 1.0; ///< of the workspace
};

/// What lasts from one Start to the next.
struct vtkHapticSession::Started
{
  std::vector<Hand> hands;
  std::shared_ptr<palpate::SessionRun> run;
};

#endif
