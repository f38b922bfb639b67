// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ErrorCause_h
#define palpate_ErrorCause_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <string>

namespace palpate
{
struct Tick;

/// Returns the name of the largest part of the force's error in one tick, such as "strain". Returns
/// "" if this part has no name. A response stores only the largest part at the depth of its
/// validity. Therefore the response is computed again up to the depth of the tick, at the corner
/// nearest to the contact. If this is impossible, for example for a response from a file, the
/// stored part is returned.
std::string causeOfError(const ViewerScene& scene, const ResponseSet& responses, const Tick& tick);
} // namespace palpate

#endif
