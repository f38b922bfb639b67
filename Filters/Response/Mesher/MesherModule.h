// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MesherModule_h
#define palpate_MesherModule_h

#include "Response/Mesher/SurfaceCut.h"
#include "Response/Mesher/SurfaceMesher.h"
#include "Response/Mesher/SurfaceRepair.h"

namespace palpate
{
/**
 * The functions of the module Mesher, libpalpateMesher.so. The module holds all code that includes
 * CGAL: it takes minutes to compile and has a licence of its own (GPL). No library links it; the
 * first call of one of these functions loads it.
 */
struct MesherModule
{
  const char* version; ///< of Palpate; the library refuses a module of another version
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
