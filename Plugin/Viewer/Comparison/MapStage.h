// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MapStage_h
#define palpate_MapStage_h

#include "ViewerScene.h"

#include "vtkNew.h"
#include "vtkRegimeMap.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <string>
#include <vector>

class vtkContactTool;

namespace palpate
{
/// Applies vtkContactRegime to a body with the material of a scene, at the depth of the scene. The
/// result does not contain the responses of the body. On failure, returns null and sets `error`.
vtkSmartPointer<vtkPolyData> judgeBody(
  const ViewerScene& scene, vtkContactTool* tool, vtkPolyData* body, std::string& error);

/// A window with several maps and one common camera.
class MapStage
{
public:
  MapStage(const std::string& name, bool onScreen);

  /// Left, bottom, right and top, as fractions of the window.
  using Viewport = std::array<double, 4>;

  /// Adds an empty view.
  vtkRenderer* addRenderer(const Viewport& viewport);
  /// Adds a body that is coloured by a vtkRegimeMap::MapQuantity. Returns the renderer of the body.
  vtkRenderer* addMap(vtkPolyData* judged, int quantity, const Viewport& viewport);
  /// Adds a line of text in the upper left corner of the last map.
  void addTitle(const std::string& title);
  void addWords(const std::string& words, const Viewport& viewport);

  /// Sets the camera of all maps so that `body` is completely visible.
  void lookFrom(vtkPolyData* body, const Direction& from, const Direction& up);

  vtkRenderWindow* window() { return this->Window; }

  /// Depending on the options, either writes map.png in the output folder, or shows the window
  /// until it is closed and then writes the picture of --screenshot. Returns "" or an error.
  std::string show(const ViewerOptions& options);

private:
  vtkNew<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  std::vector<vtkSmartPointer<vtkRegimeMap>> Maps;
};
} // namespace palpate

#endif
