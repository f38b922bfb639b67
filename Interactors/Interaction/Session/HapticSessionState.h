// SPDX-License-Identifier: BSD-3-Clause
// Private parts of vtkHapticSession.
#ifndef HapticSessionState_h
#define HapticSessionState_h

#include "Interaction/Session/BodyKernels.h"
#include "Interaction/Session/SessionRun.h"
#include "vtkHapticSession.h"

#include <memory>
#include <vector>

/// The data read from the body, by response. They are valid while the body is unchanged.
struct vtkHapticSession::Kernels : palpate::BodyKernels
{
  vtkPolyData* body = nullptr;
  vtkMTimeType time = 0;
  bool given = false; ///< whether the caller set the kernels for the next Start
};

/// The hand to which a servo scene is fitted.
struct vtkHapticSession::Hand
{
  palpate::SafetySettings safety;
  double scale = 1.0; ///< scale of the workspace
};

/// The state from one Start to the next.
struct vtkHapticSession::Started
{
  std::vector<Hand> hands;
  std::shared_ptr<palpate::SessionRun> run;
};

#endif
