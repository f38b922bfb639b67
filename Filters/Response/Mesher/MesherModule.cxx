// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Mesher/MesherModule.h"

#include "Mechanics/JoinedText.h"

#include <dlfcn.h>

namespace palpate
{
namespace
{
constexpr const char* FileName = "libpalpateMesher.so";

/// The run path of this library holds the folder of the module, in the build as when installed.
LoadedMesher load()
{
  void* library = dlopen(FileName, RTLD_NOW | RTLD_LOCAL);
  if (!library)
  {
    const char* reason = dlerror();
    return { nullptr,
      joined("the module Mesher, which makes tetrahedra with CGAL, cannot be loaded (",
        reason ? reason : FileName,
        "): install CGAL (Debian: libcgal-dev), configure with PALPATE_USE_CGAL=ON and build "
        "palpateMesher") };
  }
  using Entry = const MesherModule* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "palpateMesherModule"));
  if (!entry)
  {
    return { nullptr,
      joined(FileName, " is no module of Palpate: palpateMesherModule is missing") };
  }
  const MesherModule* module = entry();
  if (module->version != std::string(PALPATE_VERSION))
  {
    return { nullptr,
      joined(FileName, " is of version ", module->version, ", this library of ", PALPATE_VERSION) };
  }
  return { module, {} };
}
} // namespace

const LoadedMesher& loadedMesher()
{
  static const LoadedMesher mesher = load();
  return mesher;
}

bool hasSurfaceMesher()
{
  return loadedMesher().module;
}

const std::string& missingMesher()
{
  return loadedMesher().fault;
}

std::string fillSurface(
  const MeshedSurface& surface, double cells, const WorkObserver& observer, TetrahedralMesh& mesh)
{
  const LoadedMesher& mesher = loadedMesher();
  return mesher.module ? mesher.module->fill(surface, cells, observer, mesh) : mesher.fault;
}

std::string cutOff(MeshedSurface& surface, const std::vector<CutPlane>& planes, double least,
  const std::vector<CutPlane>& before)
{
  const LoadedMesher& mesher = loadedMesher();
  return mesher.module ? mesher.module->cut(surface, planes, least, before) : mesher.fault;
}

std::string mendSurface(MeshedSurface& surface, std::size_t& mended)
{
  mended = 0;
  const LoadedMesher& mesher = loadedMesher();
  return mesher.module ? mesher.module->mend(surface, mended)
                       : std::string(); // fillSurface says it
}

std::string closeSurface(MeshedSurface& surface, ClosedUp& done)
{
  const LoadedMesher& mesher = loadedMesher();
  return mesher.module ? mesher.module->close(surface, done) : mesher.fault;
}
} // namespace palpate
