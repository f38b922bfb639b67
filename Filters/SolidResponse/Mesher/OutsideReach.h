// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_OutsideReach_h
#define palpate_OutsideReach_h

#include "SolidResponse/Mesher/CurvedTetrahedra.h"
#include "SolidResponse/Mesher/SurfaceCut.h"

class vtkPolyData;

namespace palpate
{
/// Returns a function that moves places to a surface. The middle of a sharp edge is moved to an
/// edge instead: to a rim of `wanted` if it is on a cut, else to the nearest edge at which the
/// surface turns by more than the sharp angle.
EdgeReach outsideReach(
  vtkPolyData* surface, const MeshedSurface& wanted, const std::vector<CutPlane>& cuts);
} // namespace palpate

#endif
