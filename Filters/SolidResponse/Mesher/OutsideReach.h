// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OutsideReach_h
#define palpate_OutsideReach_h

#include "SolidResponse/Mesher/CurvedTetrahedra.h"
#include "SolidResponse/Mesher/SurfaceCut.h"

class vtkPolyData;

namespace palpate
{
/// Returns a function that moves positions to a surface. The middle of a sharp edge is moved to an
/// edge instead. If it is on a cut, it is moved to a rim of `wanted`. Otherwise it is moved to the
/// nearest edge of the surface whose dihedral angle exceeds the sharp angle.
EdgeReach outsideReach(
  vtkPolyData* surface, const MeshedSurface& wanted, const std::vector<CutPlane>& cuts);
} // namespace palpate

#endif
