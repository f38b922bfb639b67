// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ThicknessPicture_h
#define palpate_ThicknessPicture_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/// Draws the thickness of the layer of a scene from a scan: the body from the scene's side and from
/// the other, coloured, with a legend in mm. 1280 x 960, a PNG. Returns an error naming the file,
/// or "".
std::string drawThickness(const std::string& file, const ViewerScene& scene);
} // namespace palpate

#endif
