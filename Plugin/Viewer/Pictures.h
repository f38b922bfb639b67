// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Pictures_h
#define palpate_Pictures_h

#include "ResponseSet.h"
#include "ViewerScene.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkRenderWindow;

namespace palpate
{
/// The data of a picture: one tick of a recording, with its contact, the largest force of the
/// recording, and a remark that names the tick and the tick of the largest force.
struct PicturedMoment
{
  vtkPolyData* recording = nullptr;
  vtkIdType tick = 0;
  double largestForce = 1.0;
  std::string remark;
};

/// Returns the points whose responses the pictures show. These are the corners of the contact
/// triangle, or point 0 without a contact.
std::vector<vtkIdType> picturedPoints(vtkPolyData* body, const PicturedMoment& moment);

/// Returns the corner of the contact triangle that is nearest to the contact, or 0 without a
/// contact.
vtkIdType nearestCorner(vtkPolyData* body, const PicturedMoment& moment);

// Each of the following functions draws off screen and writes a PNG. The size is 1280 x 960 pixels,
// or 640 x 960 pixels per tool for drawSideBySide. Returns "" or an error that names the file.

/// Writes the content of a window to a file.
std::string writePicture(vtkRenderWindow* window, const std::string& file);

/// Draws two pictures of body, tool, force arrow and deflection field: a close-up, and the whole
/// body with the trail.
std::string drawContact(const std::string& closeUp, const std::string& overview,
  const ViewerScene& scene, const ResponseSet& responses, const PicturedMoment& moment);

/// Draws all tools at the tip of the tick. Each tool is on its own copy of the body, side by side.
std::string drawSideBySide(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);

/// Draws force over deflection for all tools, at the point of the body that is nearest to the
/// contact.
std::string drawCurves(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);
} // namespace palpate

#endif
