// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerModules.h"

/// The only exported symbol of the module.
extern "C" __attribute__((visibility("default"))) const palpate::ModuleTable*
palpateViewerIdentificationModule()
{
  static const palpate::IdentificationModule module{ { PALPATE_VERSION }, palpate::attachMeasured };
  return &module;
}
