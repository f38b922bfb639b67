// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchPreparation_h
#define palpate_LiveTouchPreparation_h

#include "Interaction/Session/BodyKernels.h"
#include "Haptics/Devices/HapticDevice.h"
#include "Response/Touch/TouchStart.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

class vtkPolyData;

namespace palpate
{
/// What is to be touched with what. Only read by the thread that prepares it; the body is kept
/// alive, and unchanged, by who asks.
struct LiveTouchRequest
{
  vtkPolyData* body = nullptr;
  std::string response;       ///< prefix of its arrays
  std::string device;         ///< as vtkHapticDevice::Open; "": none is to be opened
  std::optional<Sight> sight; ///< set: a place to begin at is to be found, seen so
};

/// What takes a while about that: the search structure of the body, and a device that answers.
struct PreparedLiveTouch
{
  LiveTouchRequest request;
  BodyKernels kernels;
  Eigen::Vector3d start = Eigen::Vector3d::Zero(); ///< the place to begin at, if it was asked for
  double range = 0.0;                              ///< largest Range of the response, mm
  double peak = 0.0;                    ///< largest force of the response at that depth, N
  std::unique_ptr<HapticDevice> device; ///< null for one that a session opens in no time
  std::string warning;                  ///< what is not sound about the mesh
  std::string error;                    ///< "": all is there
};

/// About 1 s for a million triangles, up to 2 s for a bridge that does not answer. On any thread.
PreparedLiveTouch prepareLiveTouch(
  const LiveTouchRequest& request, const std::function<bool()>& stale);
} // namespace palpate

#endif
