// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/LeastForm.h"

#include "Response/BodyChoice.h"
#include "Response/BodyRegime.h"

#include "vtkNew.h"

namespace palpate
{
LeastForm findLeastForm(const LeastFormRequest& request)
{
  LeastForm form;
  vtkNew<vtkPolyData> judged;
  judged->ShallowCopy(request.body);
  if (!request.complianceArray.empty())
  {
    form.error = attachRegime(Ranks(), request.body,
      { request.tool, request.name, request.deflection,
        { request.youngsModulus, request.poissonRatio, 0.0, LayerBase::Bonded, false },
        materialArrays(request.body, { "", "", request.complianceArray, "", "" }) },
      judged);
  }
  ChoiceSettings settings;
  settings.tolerance = request.tolerance;
  settings.depth = request.deflection;
  const auto body = vtkSmartPointer<vtkPolyData>::New();
  AttachedChoice attached;
  if (form.error.empty())
  {
    form.error = attachChoice(judged, request.name, settings, body, attached);
  }
  form.body = form.error.empty() ? body : nullptr;
  form.reason = attached.reason;
  return form;
}
} // namespace palpate
