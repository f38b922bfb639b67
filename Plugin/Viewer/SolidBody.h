// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SolidBody_h
#define palpate_SolidBody_h

#include "TouchScene.h"

#include <string>

namespace palpate
{
/**
 * --solid: the scene's closed surface filled with graded tetrahedra (vtkGradedBody), what its tools
 * feel on that (vtkElasticContactResponse), carried to the surface's own points, which is what one
 * goes on to touch. The scene's responses are then stored ones. A sentence on what was chosen and
 * what it took is added to its notes. Returns an error, or "".
 */
std::string attachSolidResponses(const ViewerOptions& options, TouchScene& scene);

/**
 * Carries a response from the points of `solid` to those of `body` (FacingPoints): curves and
 * depths are blended of the points around that face the same way and have a response; where most,
 * by weight, have none, or none faces that way, the point has none, by their status. Normals are
 * the body's own.
 */
void carryResponse(vtkPolyData* solid, const std::string& name, vtkPolyData* body);
} // namespace palpate

#endif
