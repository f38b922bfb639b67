// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ClearView_h
#define palpate_ClearView_h

#include "ViewerScene.h"

namespace palpate
{
/**
 * Returns the direction from which a camera sees the sites. A direction is clear if no part of the
 * body hides a site and no tool is seen nearly end-on or from below. The result is the clear
 * direction nearest to `viewFrom` of the scene. If no direction is clear for all sites, only the
 * first site is considered. If none is clear for the first site, it suffices that the first site is
 * not hidden. If even this is impossible, `viewFrom` is returned.
 */
Direction clearView(const ViewerScene& scene);
} // namespace palpate

#endif
