// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveSetup_h
#define palpate_LiveSetup_h

#include "ResponseSet.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include <string>

class vtkContactSetup;

namespace palpate
{
/// The scene as a setup whose tools and material can be changed under the hand, and its responses
/// as they are at first, written where --save and --export ask for it. Returns an error, or "".
std::string makeLiveSetup(const ViewerOptions& options, const ViewerScene& scene,
  vtkContactSetup* setup, ResponseSet& responses);
} // namespace palpate

#endif
