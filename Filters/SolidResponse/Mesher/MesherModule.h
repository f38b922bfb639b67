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
 * The functions of the module Mesher, libpalpateMesher.so. The module holds all code that includes
 * CGAL: it takes minutes to compile and has a licence of its own (GPL). No library links it; the
 * first call of one of these functions loads it.
 */
struct MesherModule : ModuleTable
{
  decltype(&fillSurface) fill;
  decltype(&cutOff) cut;
  decltype(&mendSurface) mend;
  decltype(&closeSurface) close;
};

/// The loaded module, or the reason why there is none, in words.
struct LoadedMesher
{
  const MesherModule* module = nullptr;
  std::string fault; ///< empty if there is a module
};

/// Loads the module at the first call; later calls return the same. Any thread may call it.
const LoadedMesher& loadedMesher();
} // namespace palpate

#endif
