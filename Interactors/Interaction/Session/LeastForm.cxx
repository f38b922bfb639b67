// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/LeastForm.h"

#include "vtkContactRegime.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkResponseChoice.h"

namespace palpate
{
LeastForm findLeastForm(
  const LeastFormRequest& request, const std::function<bool(vtkAlgorithm*)>& run)
{
  vtkNew<vtkResponseChoice> choose;
  choose->SetInputData(request.body);
  vtkNew<vtkContactRegime> regime;
  if (!request.complianceArray.empty())
  {
    regime->SetInputData(request.body);
    regime->SetResponseName(request.name);
    regime->SetTool(request.tool);
    regime->SetDeflection(request.deflection);
    regime->SetYoungsModulus(request.youngsModulus);
    regime->SetPoissonRatio(request.poissonRatio);
    regime->SetInputArrayToProcess(
      2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, request.complianceArray.c_str());
    if (!run(regime))
    {
      return {};
    }
    choose->SetInputData(regime->GetOutput());
  }
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
