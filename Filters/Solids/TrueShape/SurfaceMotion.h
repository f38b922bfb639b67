// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceMotion_h
#define palpate_SurfaceMotion_h

#include "Solids/FiniteElements/GlobalModes.h"
#include "Laws/NearField.h"
#include "Solids/TrueShape/RegularGreen.h"

#include <vector>

namespace palpate
{
/// Motion of the surface of a body, for a response of its true shape, in addition to the dent of a
/// tool. It consists of a few modes for the whole surface, and of the residual of the modes around
/// each source of H.
struct SurfaceMotion
{
  GlobalModes modes;
  std::vector<std::int32_t> points; ///< sources that can be pressed, in ascending order
  std::vector<NearField> near;      ///< near fields, one per point of `points`
};

/**
 * Computes the motion of a solved body. The modes (GlobalModes) are those of the displayed H. The
 * displayed H is the whole motion minus the dent of the half-space. The dent is subtracted on the
 * part of the surface whose normal is similar to that at X (VisibleDent.h). The near fields are
 * quadratic functions that are fitted by least squares to the known H around each source.
 *
 * Cost: one additional solution for each of LandmarksPerMode × `modes` sources. If the observer
 * stopped the work, the result is incomplete and has no points. The result is bit-identical for any
 * number of threads.
 */
PALPATE_EXPORT SurfaceMotion surfaceMotion(
  const RegularGreen& green, int modes, const WorkObserver& observer);
} // namespace palpate

#endif
