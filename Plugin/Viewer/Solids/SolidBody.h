// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SolidBody_h
#define palpate_SolidBody_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/**
 * Runs --solid: fills the closed surface of the scene with graded tetrahedra (vtkGradedBody), and
 * computes the responses of its tools (vtkElasticContactResponse) at the surface's own points, with
 * its curvature. The responses are stored in the scene's body and cached. The cache key contains
 * all input of the computation. Adds a sentence to the notes with the chosen sizes and the cost, or
 * with the cache file that was used. Returns "" or an error.
 */
std::string attachSolidResponses(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
