// SPDX-License-Identifier: BSD-3-Clause
#ifndef AbortedFilter_h
#define AbortedFilter_h

#include "FilterChecks.h"

#include "vtkAlgorithm.h"
#include "vtkPolyData.h"

namespace palpate::testing
{
/// Checks a filter that is aborted when its progress exceeds a fraction: its output is empty,
/// without an error. Run again, the filter completes.
template <class Filter>
void checkAborted(Filter* filter, double progress)
{
  Messages messages(filter);
  {
    const AbortAfter abort(filter, progress);
    filter->Update();
  }
  PALPATE_CHECK(messages.errors().empty());
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  filter->AbortExecuteOff();
  filter->Modified();
  filter->Update();
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() > 0);
}
} // namespace palpate::testing

#endif
