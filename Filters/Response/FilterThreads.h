// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FilterThreads_h
#define palpate_FilterThreads_h

#include "Mechanics/ThreadCount.h"

#include "vtkSMPTools.h"

#include <cstring>

namespace palpate
{
/// During the lifetime of this object, kernels that this thread calls use as many threads as VTK's
/// own loops. The object has no effect if VTK's loops are sequential (back end Sequential,
/// ParaView's default).
class FilterThreads
{
  ThreadLimit Limit{ threadCount() };

  static std::size_t threadCount()
  {
    const char* backend = vtkSMPTools::GetBackend();
    return backend == nullptr || std::strcmp(backend, "Sequential") == 0
      ? 0
      : static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  }
};
} // namespace palpate

#endif
