// SPDX-License-Identifier: BSD-3-Clause
#include "LiveTouchPreparation.h"

#include "Response/BodyConversion.h"
#include "Response/Bodies/SoundBody.h"
#include "Haptics/Devices/DeviceFit.h"
#include "Haptics/Devices/DeviceTransports.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace palpate
{
namespace
{
void openDevice(PreparedLiveTouch& made)
{
  if (isTransported(made.request.device))
  {
    made.device = openTransported(made.request.device, made.error);
  }
  if (!made.error.empty())
  {
    made.error = "Device '" + made.request.device + "': " + made.error;
  }
}

void makeKernel(PreparedLiveTouch& made)
{
  vtkPolyData* body = made.request.body;
  const std::string& name = made.request.response;
  const auto kernel = makeContactBody(body, name, made.error);
  if (!kernel)
  {
    made.error = "Wrong body: " + made.error;
    return;
  }
  made.warning = describeDefects(kernel->surface.defects());
  // makeContactBody has checked that the array exists and has this type.
  auto* range = vtkFloatArray::SafeDownCast(body->GetPointData()->GetArray(
    palpate::arrayName(name, palpate::ResponseArray::Range).c_str()));
  for (vtkIdType i = 0; range && i < range->GetNumberOfTuples(); ++i)
  {
    made.range = std::max(made.range, static_cast<double>(range->GetValue(i)));
  }
  if (!(made.range > 0.0))
  {
    made.error = "Response '" + name + "' is valid at no point of the body";
    return;
  }
  DeviceFit fit(DeviceSpecification{});
  fit.include(*kernel, made.range);
  made.peak = fit.peakForce();
  made.kernels.peaks[{ name, made.range }] = { fit.peakForce(), fit.peakStiffness() };
  made.kernels.read[name] = kernel;
  if (made.request.sight)
  {
    made.start = findTouchStart(body, name, *made.request.sight).point;
  }
}
} // namespace

PreparedLiveTouch prepareLiveTouch(
  const LiveTouchRequest& request, const std::function<bool(double)>& goOn)
{
  PreparedLiveTouch made;
  made.request = request;
  openDevice(made);
  if (made.error.empty() && goOn(0.5))
  {
    makeKernel(made);
  }
  return made;
}
} // namespace palpate
