// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerModules.h"

/// The only exported symbol of the module.
extern "C" __attribute__((visibility("default"))) const palpate::ModuleTable*
palpateViewerTrialsModule()
{
  static const palpate::TrialsModule module{ { PALPATE_VERSION }, palpate::runTrialWindow,
    palpate::runTrialConsole };
  return &module;
}
