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
/// The body and the device of a live touch. The preparing thread only reads them. The caller must
/// keep the body alive and unchanged.
struct LiveTouchRequest
{
  vtkPolyData* body = nullptr;
  std::string response; ///< prefix of the response arrays
  std::string device;   ///< device name as for vtkHapticDevice::Open; if "", no device is opened
  std::optional<Sight> sight; ///< if set, a starting point for this view is searched
};

/// The results of the preparation: the search structure of the body, and an open device.
struct PreparedLiveTouch
{
  LiveTouchRequest request;
  BodyKernels kernels;
  Eigen::Vector3d start = Eigen::Vector3d::Zero(); ///< the starting point, if it was requested
  double range = 0.0;                              ///< largest Range of the response, mm
  double peak = 0.0;                               ///< largest force of the response at `range`, N
  std::unique_ptr<HapticDevice> device; ///< null if the session itself can open the device quickly
  std::string warning;                  ///< description of the mesh's defects
  std::string error;                    ///< "" if the preparation is complete
};

/// Prepares a live touch. The cost is about 1 s for a million triangles, plus up to 2 s for a
/// bridge that does not answer. May run on any thread.
PreparedLiveTouch prepareLiveTouch(
  const LiveTouchRequest& request, const std::function<bool(double)>& goOn);
} // namespace palpate

#endif
