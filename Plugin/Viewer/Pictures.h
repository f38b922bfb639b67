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
/// The moment of a picture: one tick of a recording, its contact, and the recording's largest
/// force.
struct PicturedMoment
{
  vtkPolyData* recording = nullptr;
  vtkIdType tick = 0;
  double largestForce = 1.0;
};

/// The corner of the contact triangle nearest to the contact; 0 without a contact.
vtkIdType nearestCorner(vtkPolyData* body, const PicturedMoment& moment);

// Each draws off screen, 1280 x 960 (side by side 640 x 960 per tool), and writes a PNG. Returns an
// error naming the file, or "".

/// What a window shows.
std::string writePicture(vtkRenderWindow* window, const std::string& file);

/// The body, the tool, the force arrow and the dent.
std::string drawOverview(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);

/// The deflection field from close up.
std::string drawCloseUp(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);

/// All tools at the tip of the moment, side by side on copies of the body.
std::string drawSideBySide(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);

/// Force over deflection of all tools at the point of the body next to the contact.
std::string drawCurves(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment);
} // namespace palpate

#endif
