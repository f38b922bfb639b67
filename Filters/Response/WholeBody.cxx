// SPDX-License-Identifier: BSD-3-Clause
#include "Response/WholeBody.h"

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Response/Bodies/BodyYield.h"
#include "Response/BodyConversion.h"
#include "vtkContactTool.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace palpate
{
namespace
{
bool isOfOneMaterial(const LawRequest& request)
{
  const bool varies = std::any_of(request.arrays.begin(), request.arrays.end(),
    [](const MaterialArray& array) { return !array.name.empty(); });
  return !varies && !request.measured && request.material.thickness == 0.0 &&
    !request.material.isStack() && request.material.poissonRatio <= LargestYieldRatio;
}
} // namespace

WholeBody includeWholeBody(const Ranks& ranks, vtkPolyData* body,
  const std::function<bool(double)>& goOn, LawRequest& request)
{
  WholeBody made;
  made.body = body;
  if (!request.wholeBody || request.couples || !ranks.areAlone() || !isOfOneMaterial(request) ||
    !makeBodyMesh(body).isClosed())
  {
    return made;
  }
  const double radius = request.tool->GetKernel()->contactRadius(request.deflection);
  const YieldRequest asked{ request.material.youngsModulus, request.material.poissonRatio, radius,
    {} };
  BodyYield found;
  const std::string fault = findYield(body, asked, goOn, found);
  if (!fault.empty())
  {
    made.warning = "The deflection of the whole body is not included, since " + fault;
    return made;
  }
  made.isComplete = !found.compliance.empty();
  if (isAccurate(found, body, asked))
  {
    made.body = vtkSmartPointer<vtkPolyData>::New();
    made.body->ShallowCopy(body);
    attachYield(found, made.body);
    made.heldAt = found.heldAt;
    made.warning = found.warnings.empty() ? std::string() : found.warnings.front();
    request.arrays[ComplianceArrayIndex] = { FoundCompliance,
      made.body->GetPointData()->GetArray(FoundCompliance) };
  }
  return made;
}
} // namespace palpate
