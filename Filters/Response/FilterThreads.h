// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FilterThreads_h
#define palpate_FilterThreads_h

#include "Mechanics/ThreadCount.h"

#include "vtkSMPTools.h"

#include <cstring>

namespace palpate
{
/// During its lifetime, kernels called by this thread use as many threads as VTK's own loops. It
/// has no effect if VTK's loops are not threaded (back end Sequential, ParaView's default).
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
