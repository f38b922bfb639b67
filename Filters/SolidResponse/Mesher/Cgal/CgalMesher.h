// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CgalMesher_h
#define palpate_CgalMesher_h

#include "SolidResponse/Mesher/SurfaceCut.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"
#include "SolidResponse/Mesher/SurfaceRepair.h"

namespace palpate
{
/// Implementations of the functions of SurfaceMesher.h, SurfaceCut.h and SurfaceRepair.h with CGAL.
std::string fillByCgal(
  const MeshedSurface& surface, double cells, const WorkObserver& observer, TetrahedralMesh& mesh);
std::string cutByCgal(MeshedSurface& surface, const std::vector<CutPlane>& planes, double least,
  const std::vector<CutPlane>& before);
std::string mendByCgal(MeshedSurface& surface, std::size_t& mended);
std::string closeByCgal(MeshedSurface& surface, ClosedUp& done);
} // namespace palpate

#endif
