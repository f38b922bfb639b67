// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OutsideReach_h
#define palpate_OutsideReach_h

#include "SolidResponse/Mesher/CurvedTetrahedra.h"
#include "SolidResponse/Mesher/SurfaceCut.h"

class vtkPolyData;

namespace palpate
{
/// Moves places to a surface; those between two on an edge to that edge, which is a rim of `wanted`
/// where they lie on a cut, else the nearest by which the surface turns more than the sharp angle.
EdgeReach outsideReach(
  vtkPolyData* surface, const MeshedSurface& wanted, const std::vector<CutPlane>& cuts);
} // namespace palpate

#endif
