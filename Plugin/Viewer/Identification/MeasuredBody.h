// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredBody_h
#define palpate_MeasuredBody_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/**
 * Attaches responses of all tools of a scene to its body. The responses are computed from curves
 * measured on the body (--measured, --register). Their prefixes are "Response" for the first tool,
 * then "Response2" ... The notes of the scene list the result for each site. The contact is at the
 * first site unless the options give another position. Returns "" or an error.
 */
std::string attachMeasured(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
