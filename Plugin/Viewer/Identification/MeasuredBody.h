// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredBody_h
#define palpate_MeasuredBody_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/**
 * Gives the body of a scene the responses of all its tools, from the curves measured on it
 * (--measured, --register): "Response" for the first tool, then "Response2" ... The notes of the
 * scene list the result for each site. The contact is at the first site unless a place is given.
 * Returns "" or an error.
 */
std::string attachMeasured(const ViewerOptions& options, ViewerScene& scene);
} // namespace palpate

#endif
