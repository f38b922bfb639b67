// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_WholeBodyScene_h
#define palpate_WholeBodyScene_h

#include "ViewerOptions.h"
#include "ViewerScene.h"

namespace palpate
{
/**
 * Attaches the compliance of the body as a whole (BodyYield) to a user's body, for the widest
 * contact of the scene's tools. The scene is unchanged if the body is open, has a response, has
 * layers or has triangles that are too large, or if an option excludes the compliance
 * (--no-whole-body, --hand, --trial). If the compliance cannot be computed, the scene is unchanged
 * and a warning is printed on stderr. The computation takes seconds, and reports its progress on
 * stderr.
 */
void addBodyCompliance(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
