// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SolidBody_h
#define palpate_SolidBody_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/**
 * --solid: fills the scene's closed surface with graded tetrahedra (vtkGradedBody), and computes
 * the responses of its tools (vtkElasticContactResponse) at the surface's own points, with its
 * curvature. The scene's responses are then stored ones, and cached by their input. A sentence on
 * what was chosen and its cost, or on the cache used, is added to the notes. Returns an error, or
 * "".
 */
std::string attachSolidResponses(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
