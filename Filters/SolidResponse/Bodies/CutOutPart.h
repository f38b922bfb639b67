// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CutOutPart_h
#define palpate_CutOutPart_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "SolidResponse/Mesher/PreparedSurface.h"

#include <string>
#include <vector>

namespace palpate
{
/// What lies in a box around a place.
struct CutOutSurface
{
  PreparedSurface surface;
  std::vector<CutPlane> sides; ///< of the box, where they cut anything off
};

/// The same in cells that are fine at the place.
struct CutOutPart
{
  VolumeMesh mesh;
  std::vector<unsigned char> onCut; ///< per node: whether it lies where the part was cut off
  std::vector<unsigned char> held;  ///< and whether it is held, which it then is alone
};

/// The lengths of a part's cells.
struct PartCells
{
  double spacing = 0.0; ///< at the surface, mm, where no ball asks for finer ones
  std::vector<FineBall> balls;
};

/**
 * Cuts what lies in a box of half a side `half` (mm) around a place out of a surface that has been
 * mended and cut. Returns what is wrong, or "". From any number of threads, as the next. Cost: some
 * tenths of a second for 100 thousand triangles.
 */
std::string cutOutAround(
  const PreparedSurface& body, const Eigen::Vector3d& place, double half, CutOutSurface& part);

/// Fills it with quadratic tetrahedra, but for crumbs that are held nowhere. Returns what is wrong,
/// or
/// "". Cost: 60 µs a cell.
std::string fillPart(const CutOutSurface& part, const PartCells& cells, CutOutPart& filled);
} // namespace palpate

#endif
