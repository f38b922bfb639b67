// SPDX-License-Identifier: BSD-3-Clause
#include "LeastForm.h"

#include "vtkContactRegime.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkResponseChoice.h"

namespace palpate
{
namespace
{
/// The regime of the tool on the bare body, added to `body`.
bool addRegime(
  const LeastFormRequest& request, vtkPolyData* body, const std::function<bool(vtkAlgorithm*)>& run)
{
  const char* const compliance = request.complianceArray.c_str();
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(request.body->GetPoints());
  bare->SetPolys(request.body->GetPolys());
  bare->GetPointData()->AddArray(request.body->GetPointData()->GetArray(compliance));
  vtkNew<vtkContactRegime> regime;
  regime->SetInputData(bare);
  regime->SetTool(request.tool);
  regime->SetDeflection(request.deflection);
  regime->SetYoungsModulus(request.youngsModulus);
  regime->SetPoissonRatio(request.poissonRatio);
  regime->SetInputArrayToProcess(2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, compliance);
  if (!run(regime))
  {
    return false;
  }
  vtkPolyData* judged = regime->GetOutput();
  body->GetPointData()->AddArray(judged->GetPointData()->GetArray("RegimeVerdict"));
  vtkNew<vtkFieldData> fields; // a shallow copy shares the other's
  fields->ShallowCopy(body->GetFieldData());
  fields->AddArray(judged->GetFieldData()->GetArray("RegimeDeflection"));
  body->SetFieldData(fields);
  return true;
}
} // namespace

LeastForm findLeastForm(
  const LeastFormRequest& request, const std::function<bool(vtkAlgorithm*)>& run)
{
  vtkNew<vtkPolyData> judged;
  judged->ShallowCopy(request.body);
  if (!request.complianceArray.empty() && !addRegime(request, judged, run))
  {
    return {};
  }
  vtkNew<vtkResponseChoice> choose;
  choose->SetInputData(judged);
  choose->SetResponseName(request.name);
  choose->SetTolerance(request.tolerance);
  choose->SetDeflection(request.deflection);
  if (!run(choose))
  {
    return {};
  }
  LeastForm form;
  form.body = vtkSmartPointer<vtkPolyData>::New(); // and not the filter's
  form.body->ShallowCopy(choose->GetOutput());
  form.reason = choose->GetReason();
  return form;
}
} // namespace palpate
