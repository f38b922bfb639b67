// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerModules.h"

/// The only exported symbol of the module.
extern "C" __attribute__((visibility("default"))) const palpate::ModuleTable*
palpateViewerComparisonModule()
{
  static const palpate::ComparisonModule module{ { PALPATE_VERSION }, palpate::runComparison,
    palpate::runComparisonWindow, palpate::runRegimeMap };
  return &module;
}
