// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceMotion_h
#define palpate_SurfaceMotion_h

#include "Solids/FiniteElements/GlobalModes.h"
#include "Laws/NearField.h"
#include "Solids/TrueShape/RegularGreen.h"

#include <vector>

namespace palpate
{
/// How the surface of a body of true shape moves beside the dent of a tool: a few modes for the
/// whole of it, and around each source of its H what they leave.
struct SurfaceMotion
{
  GlobalModes modes;
  std::vector<std::int32_t> points; ///< sources that can be pressed, ascending
  std::vector<NearField> near;      ///< beside them
};

/**
 * Of a body that has been solved for. The modes are those of H as drawn, see GlobalModes: of the
 * whole motion less the half-space's dent on the surface that faces as X does (VisibleDent.h). The
 * near fields are quadratics by least squares through H where it was solved for around each source.
 *
 * Costs one more solution for each of LandmarksPerMode × `modes` sources. Not complete (no points)
 * when the observer stopped it. The same bits for any number of threads.
 */
PALPATE_EXPORT SurfaceMotion surfaceMotion(
  const RegularGreen& green, int modes, const WorkObserver& observer);
} // namespace palpate

#endif
