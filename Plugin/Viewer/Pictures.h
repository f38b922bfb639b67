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

/// The points whose responses the pictures show: the corners of the contact triangle; point 0
/// without a contact.
std::vector<vtkIdType> picturedPoints(vtkPolyData* body, const PicturedMoment& moment);

/// The corner of the contact triangle nearest to the contact; 0 without a contact.
vtkIdType nearestCorner(vtkPolyData* body, const PicturedMoment& moment);

// Each function draws off screen, 1280 x 960 (side by side 640 x 960 per tool), and writes a PNG.
// Returns "" or an error that names the file.

/// Writes the content of a window.
std::string writePicture(vtkRenderWindow* window, const std::string& file);

/// Draws two pictures of body, tool, force arrow and deflection field: a close-up, and the whole
/// body with the trail.
std::string drawContact(const std::string& closeUp, const std::string& overview,
  const ViewerScene& scene, const ResponseSet& responses, const PicturedMoment& moment);

/// Draws all tools at the tip of the tick, side by side on copies of the body.
std::string drawSideBySide(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);

/// Draws force over deflection of all tools at the point of the body nearest to the contact.
std::string drawCurves(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);
} // namespace palpate

#endif
