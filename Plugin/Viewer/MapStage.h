// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MapStage_h
#define palpate_MapStage_h

#include "TouchScene.h"

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
  const TouchScene& scene, vtkContactTool* tool, vtkPolyData* body, std::string& error);

/// A window of regime maps, all seen by one camera.
class MapStage
{
public:
  MapStage(const std::string& name, bool onScreen);

  using Viewport = std::array<double, 4>; ///< left, bottom, right, top

  /// Adds a body by a vtkRegimeMap::MapQuantity; its renderer, to add to.
  vtkRenderer* addMap(vtkPolyData* judged, int quantity, const Viewport& viewport);
  /// A line in the upper left corner of the last map.
  void addTitle(const std::string& title);
  void addWords(const std::string& words, const Viewport& viewport);

  /// All maps; `body` is seen whole.
  void lookFrom(vtkPolyData* body, const Direction& from, const Direction& up);

  vtkRenderWindow* window() { return this->Window; }

private:
  vtkNew<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  std::vector<vtkSmartPointer<vtkRegimeMap>> Maps;
};
} // namespace palpate

#endif
