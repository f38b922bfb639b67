// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/Cgal/CgalMesher.h"

#include "SolidResponse/Mesher/MesherModule.h"

/// The only symbol that the module exports.
extern "C" __attribute__((visibility("default"))) const palpate::ModuleTable* palpateMesherModule()
{
  static const palpate::MesherModule module{ { PALPATE_VERSION }, palpate::fillByCgal,
    palpate::cutByCgal, palpate::mendByCgal, palpate::closeByCgal };
  return &module;
}
