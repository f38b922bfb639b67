// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

/// Filters run on two threads of the STDThread back end. Every VTK has this back end, and the
/// machine on which the targets were set has two cores.
int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(2);
  benchmark::AddCustomContext("vtkSMPTools", "STDThread, 2 threads");
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
