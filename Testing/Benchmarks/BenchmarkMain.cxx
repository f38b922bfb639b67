// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMPTools.h"

#include <benchmark/benchmark.h>

/// Filters run on two threads of the STDThread back end: the one every VTK has, and the cores of
/// the machine the targets were set on.
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
