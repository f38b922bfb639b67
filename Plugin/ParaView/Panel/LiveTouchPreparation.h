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
/// The body and device of a touch. Only read by the preparing thread; the caller keeps the body
/// alive and unchanged.
struct LiveTouchRequest
{
  vtkPolyData* body = nullptr;
  std::string response;       ///< prefix of its arrays
  std::string device;         ///< as for vtkHapticDevice::Open; "": none is opened
  std::optional<Sight> sight; ///< if set, a start is to be found for this view
};

/// The results that take time: the search structure of the body, and a device that answers.
struct PreparedLiveTouch
{
  LiveTouchRequest request;
  BodyKernels kernels;
  Eigen::Vector3d start = Eigen::Vector3d::Zero(); ///< the start, if requested
  double range = 0.0;                              ///< largest Range of the response, mm
  double peak = 0.0;                    ///< largest force of the response at that depth, N
  std::unique_ptr<HapticDevice> device; ///< null for one that a session opens quickly
  std::string warning;                  ///< the defects of the mesh
  std::string error;                    ///< "": complete
};

/// Cost: about 1 s for a million triangles, up to 2 s for a bridge that does not answer. On any
/// thread.
PreparedLiveTouch prepareLiveTouch(
  const LiveTouchRequest& request, const std::function<bool()>& stale);
} // namespace palpate

#endif
