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
/// Returns the result of vtkContactRegime for a body with the material of a scene, at the depth of
/// the scene, without the responses of the body. Returns null and an error on failure.
vtkSmartPointer<vtkPolyData> judgeBody(
  const ViewerScene& scene, vtkContactTool* tool, vtkPolyData* body, std::string& error);

/// A window of maps with a common camera.
class MapStage
{
public:
  MapStage(const std::string& name, bool onScreen);

  using Viewport = std::array<double, 4>; ///< left, bottom, right, top

  /// Adds an empty view.
  vtkRenderer* addRenderer(const Viewport& viewport);
  /// Adds a body coloured by a vtkRegimeMap::MapQuantity; returns its renderer.
  vtkRenderer* addMap(vtkPolyData* judged, int quantity, const Viewport& viewport);
  /// Adds a line of text in the upper left corner of the last map.
  void addTitle(const std::string& title);
  void addWords(const std::string& words, const Viewport& viewport);

  /// Sets the camera of all maps so that `body` is completely visible.
  void lookFrom(vtkPolyData* body, const Direction& from, const Direction& up);

  vtkRenderWindow* window() { return this->Window; }

  /// Depending on the options, writes map.png in the output folder, or shows the window until it is
  /// closed and then writes its --screenshot. Returns "" or an error.
  std::string show(const ViewerOptions& options);

private:
  vtkNew<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  std::vector<vtkSmartPointer<vtkRegimeMap>> Maps;
};
} // namespace palpate

#endif
