// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Mesher/MesherModule.h"

#include "Mechanics/JoinedText.h"

namespace palpate
{
namespace
{
LoadedMesher load()
{
  const LoadedModule loaded = loadModule("palpateMesher");
  if (!loaded.table)
  {
    return { nullptr,
      joined("the module Mesher, which makes tetrahedra with CGAL, cannot be loaded (",
        loaded.fault,
        "): install CGAL (Debian: libcgal-dev), configure with PALPATE_USE_CGAL=ON and build "
        "palpateMesher") };
  }
  return { static_cast<const MesherModule*>(loaded.table), {} };
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
                       : std::string(); // "" because fillSurface reports the missing module
}

std::string closeSurface(MeshedSurface& surface, ClosedUp& done)
{
  const LoadedMesher& mesher = loadedMesher();
  return mesher.module ? mesher.module->close(surface, done) : mesher.fault;
}
} // namespace palpate
