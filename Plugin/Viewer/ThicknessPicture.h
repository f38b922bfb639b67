// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ThicknessPicture_h
#define palpate_ThicknessPicture_h

#include "ViewerScene.h"

#include <string>

namespace palpate
{
/// Draws the layer thickness of a scene from a scan. The picture shows the coloured body from the
/// view direction of the scene and from the opposite side, with a legend in mm. It is a PNG of 1280
/// x 960 pixels. Returns "" or an error that names the file.
std::string drawThickness(const std::string& file, const ViewerScene& scene);
} // namespace palpate

#endif
