// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorCause.h"

#include "Contact/ResponseContract.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
const std::string CauseName = "ErrorCause";

vtkIdType cornerNearestTo(vtkPolyData* body, const Tick& tick)
{
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(
    body->GetNumberOfVerts() + body->GetNumberOfLines() + tick.contact.triangle, corners);
  return *std::min_element(corners->begin(), corners->end(),
    [&](vtkIdType a, vtkIdType b)
    {
      const Eigen::Vector3d& contact = tick.contact.contactPoint;
      return (Eigen::Vector3d(body->GetPoint(a)) - contact).norm() <
        (Eigen::Vector3d(body->GetPoint(b)) - contact).norm();
    });
}

std::string storedLimit(vtkPolyData* body, const std::string& response, vtkIdType point)
{
  vtkDataArray* limit =
    body->GetPointData()->GetArray(arrayName(response, ResponseArray::Limit).c_str());
  return limit ? limitInWords(static_cast<int>(limit->GetTuple1(point))) : "";
}
} // namespace

std::string causeOfError(const ViewerScene& scene, const ResponseSet& responses, const Tick& tick)
{
  const vtkIdType point = cornerNearestTo(responses.body, tick);
  const double depth = tick.contact.deflection;
  if (scene.stored || !(scene.terms.errorTolerance > 0.0) || !(depth > 0.0))
  {
    return storedLimit(responses.body, responses.names.front(), point);
  }
  // The last sample of the first response contains the error at the depth of the tick. The
  // tolerance of the second response is just below this error, so that its validity ends at this
  // sample.
  vtkSmartPointer<vtkPolyData> judged;
  std::string fault = attachAtPoints(
    scene, responses, { point }, CauseName, depth, scene.terms.errorTolerance, judged);
  double error = 0.0;
  if (fault.empty())
  {
    vtkDataArray* errors =
      judged->GetPointData()->GetArray(arrayName(CauseName, ResponseArray::Error).c_str());
    error = errors ? errors->GetComponent(point, errors->GetNumberOfComponents() - 1) : 0.0;
  }
  if (!(error > 0.0) || !std::isfinite(error))
  {
    return storedLimit(responses.body, responses.names.front(), point);
  }
  // The factor allows for the rounding of the error, which is a float.
  constexpr double justBelow = 1.0 - 1e-4;
  fault = attachAtPoints(scene, responses, { point }, CauseName, depth, justBelow * error, judged);
  if (!fault.empty())
  {
    return {};
  }
  return storedLimit(judged, CauseName, point);
}
} // namespace palpate
