// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_WholeBodyScene_h
#define palpate_WholeBodyScene_h

#include "ViewerOptions.h"
#include "ViewerScene.h"

namespace palpate
{
/**
 * Attaches the compliance of the body as a whole to a user's body (BodyYield), for the widest
 * contact of the scene's tools. The scene stays as it is if the body is open, has a response or
 * layers, or if the options exclude it (--no-whole-body, --hand, --trial); if the triangles are too
 * large; and with a warning on stderr if the compliance cannot be found. Takes seconds, and reports
 * its progress on stderr.
 */
void addBodyCompliance(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
