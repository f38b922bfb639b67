// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredBody_h
#define palpate_MeasuredBody_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/**
 * Attaches the responses of all tools of a scene to its body, from curves measured on the body
 * (--measured, --register): "Response" for the first tool, then "Response2" ... The notes of the
 * scene list the result for each site. The contact is at the first site unless the options name a
 * place. Returns "" or an error.
 */
std::string attachMeasured(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
