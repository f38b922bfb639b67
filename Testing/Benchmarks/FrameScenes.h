// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_FrameScenes_h
#define palpate_benchmarks_FrameScenes_h

#include "vtkContactScene.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <string>

namespace palpate::benchmarks
{
/// How the body of a scene is drawn. The rest of the scene is the same.
enum class FramePath
{
  Plain,  ///< without the dent, by VTK's own mapper, in the colours of the legend
  Shader, ///< with the dent, in the vertex shader
  Filter  ///< with the dent, by vtkContactDeflection
};

std::string nameOf(FramePath path);

/// An off-screen window with a scene whose contact moves.
class FrameScene
{
public:
  /// `probed`: contacts of a probe with `body`. `body` must have responses.
  FrameScene(FramePath path, vtkPolyData* body, vtkPolyData* probed);

  /// Draws one frame. Returns the seconds from the new contact to the finished picture.
  double draw(vtkIdType contact);

  FramePath path() const { return this->Path; }

private:
  FramePath Path;
  vtkSmartPointer<vtkPolyData> Probed;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkContactScene> Scene;
};
} // namespace palpate::benchmarks

#endif
