// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FilterStage_h
#define palpate_FilterStage_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkVersionMacros.h"

namespace palpate
{
/// Returns whether a filter must stop. A filter must stop if an abort was requested for it or,
/// since VTK 9.3, for an earlier filter of the pipeline.
inline bool isAborted(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

/// A part of a filter's work. A call reports progress within [from, to] and returns whether to
/// continue.
struct FilterStage
{
  vtkAlgorithm* filter;
  double from;
  double to;

  bool operator()(double done) const
  {
    this->filter->UpdateProgress(this->from + done * (this->to - this->from));
    return !isAborted(this->filter);
  }
};

/// Updates the filter `inner`, which `stage.filter` uses internally. Forwards the progress of
/// `inner` to `stage`, and passes an abort to `inner`. Returns false if the work was aborted.
inline bool runWithin(vtkAlgorithm* inner, FilterStage stage)
{
  vtkNew<vtkCallbackCommand> forward;
  forward->SetClientData(&stage);
  forward->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* running = static_cast<vtkAlgorithm*>(caller);
      if (!(*static_cast<FilterStage*>(data))(running->GetProgress()))
      {
        running->SetAbortExecute(1);
      }
    });
  const unsigned long tag = inner->AddObserver(vtkCommand::ProgressEvent, forward);
  inner->Update();
  inner->RemoveObserver(tag);
  return stage(1.0);
}
} // namespace palpate

#endif
