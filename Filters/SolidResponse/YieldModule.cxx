// SPDX-License-Identifier: BSD-3-Clause
#include "Response/FilterStage.h"
#include "SolidResponse/Bodies/YieldSolution.h"

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

namespace palpate
{
namespace
{
std::string find(vtkPolyData* body, const YieldRequest& request,
  const std::function<bool(double)>& goOn, BodyYield& made)
{
  const std::string fault = checkYieldRequest(request);
  if (!fault.empty())
  {
    return fault;
  }
  // The steps of the work report their progress to this filter, which passes the progress to
  // `goOn`.
  vtkNew<vtkPolyDataAlgorithm> caller;
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(const_cast<std::function<bool(double)>*>(&goOn));
  forward->SetCallback(
    [](vtkObject* filter, unsigned long, void* data, void*)
    {
      auto* running = static_cast<vtkAlgorithm*>(filter);
      const auto& observer = *static_cast<const std::function<bool(double)>*>(data);
      if (observer && !observer(running->GetProgress()))
      {
        running->SetAbortExecute(1);
      }
    });
  caller->AddObserver(vtkCommand::ProgressEvent, forward);
  return solveYield(body, request, caller, made);
}
} // namespace
} // namespace palpate

extern "C" PALPATESOLIDRESPONSE_EXPORT const palpate::ModuleTable* palpateSolidResponseModule()
{
  static const palpate::YieldModule module{ { PALPATE_VERSION }, palpate::find };
  return &module;
}
