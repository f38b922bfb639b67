// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ErrorCause_h
#define palpate_ErrorCause_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <string>

namespace palpate
{
struct Tick;

/// Names the largest part of the force's error in one tick ("strain"); "" if this part has no name.
/// A response stores only which part is the largest at its validity. The response is therefore
/// computed again up to the depth of the tick, at the corner nearest to the contact. Where that is
/// impossible, as for a response from a file, the stored part is returned.
std::string causeOfError(const ViewerScene& scene, const ResponseSet& responses, const Tick& tick);
} // namespace palpate

#endif
