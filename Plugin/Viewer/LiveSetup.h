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
/// The scene as a setup whose tools and material can be changed during contact, with its initial
/// responses, which are written for --save and --export. Returns an error, or "".
std::string makeLiveSetup(const ViewerOptions& options, const ViewerScene& scene,
  vtkContactSetup* setup, ResponseSet& responses);
} // namespace palpate

#endif
