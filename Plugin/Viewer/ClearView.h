// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ClearView_h
#define palpate_ClearView_h

#include "ViewerScene.h"

namespace palpate
{
/**
 * The direction from which a camera sees where the scene is touched: the direction nearest to
 * `viewFrom` of the scene from which no part of the body hides the sites and no tool is seen nearly
 * end-on or from below. If there is none, only the first site is considered, then only its line of
 * sight. Returns `viewFrom` if no direction is clear.
 */
Direction clearView(const ViewerScene& scene);
} // namespace palpate

#endif
