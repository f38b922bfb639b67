// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerModules.h"

/// The only exported symbol of the module.
extern "C" __attribute__((visibility("default"))) const palpate::ModuleTable*
palpateViewerSolidsModule()
{
  static const palpate::SolidsModule module{ { PALPATE_VERSION }, palpate::attachSolidResponses,
    palpate::attachVoxelCompliance, palpate::makeComparedBodies, palpate::makePhantomScene,
    palpate::makeSegmentedScene };
  return &module;
}
