// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ErrorCause_h
#define palpate_ErrorCause_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include <string>

namespace palpate
{
struct Tick;

/// The largest part of the error of the force in one tick, in words ("strain"); "" if the largest
/// part has no name. The response stores which part is the largest at the depth of its validity, so
/// the response is made again up to the depth of the tick, at the corner nearest to the contact.
/// Where that is impossible, as for a response from a file, the stored part is returned.
std::string causeOfError(const ViewerScene& scene, const ResponseSet& responses, const Tick& tick);
} // namespace palpate

#endif
