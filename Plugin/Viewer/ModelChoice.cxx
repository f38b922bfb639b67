// SPDX-License-Identifier: BSD-3-Clause
#include "ModelChoice.h"

#include "MapStage.h"

#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkResponseChoice.h"

#include <chrono>

namespace palpate
{
namespace
{
/// Adds the regime of the first tool. Returns an error, or "".
std::string addRegime(const TouchScene& scene, const ResponseSet& responses, vtkPolyData* body)
{
  std::string error;
  const vtkSmartPointer<vtkPolyData> judged =
    judgeBody(scene, responses.tools.front(), body, error);
  if (error.empty())
  {
    body->GetPointData()->AddArray(judged->GetPointData()->GetArray("RegimeVerdict"));
    vtkNew<vtkFieldData> fields; // a shallow copy shares the other's
    fields->ShallowCopy(body->GetFieldData());
    fields->AddArray(judged->GetFieldData()->GetArray("RegimeDeflection"));
    body->SetFieldData(fields);
  }
  return error;
}
} // namespace

std::string chooseModel(const ViewerOptions& options, const TouchScene& scene,
  const ResponseSet& responses, ModelChoice& choice)
{
  choice.body = responses.body;
  if (!options.automatic)
  {
    return {};
  }
  const auto begin = std::chrono::steady_clock::now();
  vtkNew<vtkPolyData> judged;
  judged->ShallowCopy(responses.body);
  std::string error = scene.solid ? addRegime(scene, responses, judged) : std::string();
  if (!error.empty())
  {
    return error;
  }
  vtkNew<vtkResponseChoice> choose;
  choose->SetInputData(judged);
  choose->SetResponseName(responses.names.front());
  choose->SetTolerance(options.tolerance);
  choose->SetDeflection(scene.depth);
  error = updateQuietly(choose);
  if (error.empty())
  {
    choice.body = choose->GetOutput();
    choice.reason = choose->GetReason();
  }
  choice.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return error;
}

std::string shortReason(const ModelChoice& choice)
{
  return choice.reason.substr(0, choice.reason.find(';'));
}
} // namespace palpate
