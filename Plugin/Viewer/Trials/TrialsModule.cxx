// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerModules.h"

/// The only symbol that the module exports.
extern "C" __attribute__((visibility("default"))) const palpate::ModuleTable*
palpateViewerTrialsModule()
{
  static const palpate::TrialsModule module{ { PALPATE_VERSION }, palpate::runTrialWindow,
    palpate::runTrialConsole };
  return &module;
}
