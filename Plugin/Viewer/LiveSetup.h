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
/// Makes a setup of the scene, whose tools and material can be changed during contact, and its
/// initial responses. The files of --save and --export contain these responses. Returns "" or an
/// error.
std::string makeLiveSetup(const ViewerOptions& options, const ViewerScene& scene,
  vtkContactSetup* setup, ResponseSet& responses);
} // namespace palpate

#endif
