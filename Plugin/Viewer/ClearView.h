// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ClearView_h
#define palpate_ClearView_h

#include "ViewerScene.h"

namespace palpate
{
/**
 * Returns the direction from which a camera sees the sites. Of all directions from which no part of
 * the body hides a site and no tool is seen nearly end-on or from below, it is the one nearest to
 * `viewFrom` of the scene. If there is none, only the first site is considered, then only its line
 * of sight. Returns `viewFrom` if no direction is clear.
 */
Direction clearView(const ViewerScene& scene);
} // namespace palpate

#endif
