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
/// What vtkContactRegime says of a body with the material of a scene, at the scene's depth; without
/// its responses. Null and an error if it cannot.
vtkSmartPointer<vtkPolyData> judgeBody(
  const ViewerScene& scene, vtkContactTool* tool, vtkPolyData* body, std::string& error);

/// A window of maps, all seen by one camera.
class MapStage
{
public:
  MapStage(const std::string& name, bool onScreen);

  using Viewport = std::array<double, 4>; ///< left, bottom, right, top

  /// Adds an empty view.
  vtkRenderer* addRenderer(const Viewport& viewport);
  /// Adds a body by a vtkRegimeMap::MapQuantity; its renderer, to add to.
  vtkRenderer* addMap(vtkPolyData* judged, int quantity, const Viewport& viewport);
  /// A line in the upper left corner of the last map.
  void addTitle(const std::string& title);
  void addWords(const std::string& words, const Viewport& viewport);

  /// All maps; `body` is seen whole.
  void lookFrom(vtkPolyData* body, const Direction& from, const Direction& up);

  vtkRenderWindow* window() { return this->Window; }

  /// As the options say: map.png in the output folder, or the window until it is closed, then its
  /// --screenshot. Returns an error, or "".
  std::string show(const ViewerOptions& options);

private:
  vtkNew<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  std::vector<vtkSmartPointer<vtkRegimeMap>> Maps;
};
} // namespace palpate

#endif
