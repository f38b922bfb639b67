// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SolidBody_h
#define palpate_SolidBody_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/**
 * --solid: the scene's closed surface filled with graded tetrahedra (vtkGradedBody), what its tools
 * feel on that (vtkElasticContactResponse) at the surface's own points, curved as it is. The
 * scene's responses are then stored ones, and kept in the cache for the next time, by what they
 * depend on. A sentence on what was chosen and what it took, or where it was taken from, is added
 * to its notes. Returns an error, or "".
 */
std::string attachSolidResponses(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
