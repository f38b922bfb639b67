// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MesherModule_h
#define palpate_MesherModule_h

#include "Mechanics/Files/ModuleFile.h"
#include "SolidResponse/Mesher/SurfaceCut.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"
#include "SolidResponse/Mesher/SurfaceRepair.h"

namespace palpate
{
/**
 * The functions of the module Mesher, libpalpateMesher.so. The module contains all code that
 * includes CGAL, because CGAL takes minutes to compile and has a different licence (GPL). No
 * library links the module. The first call of one of these functions loads the module.
 */
struct MesherModule : ModuleTable
{
  decltype(&fillSurface) fill;
  decltype(&cutOff) cut;
  decltype(&mendSurface) mend;
  decltype(&closeSurface) close;
};

/// The loaded module, or the reason why it is missing.
struct LoadedMesher
{
  const MesherModule* module = nullptr;
  std::string fault; ///< reason why the module is missing; empty if the module is loaded
};

/// Loads the module at the first call. Later calls return the same result. Thread-safe.
const LoadedMesher& loadedMesher();
} // namespace palpate

#endif
