// SPDX-License-Identifier: BSD-3-Clause
// The body of a scene, drawn by shader or by filter in one window, and measured pixel by pixel:
// distance, colours, cells.
#ifndef palpate_testing_TwoPaths_h
#define palpate_testing_TwoPaths_h

#include "Picture.h"
#include "SceneBodies.h"
#include "Contact/TriangleProjection.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkContactScene.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <vector>

namespace palpate::testing
{
class TwoPaths
{
public:
  static constexpr int Size = 240;            // pixels
  static constexpr float Background = 0.999F; // value of the depth buffer

  /// Sets a camera that looks at `focus` from `direction`, in parallel projection. The height of
  /// the picture is 2 `half` mm.
  TwoPaths(vtkContactScene* scene, const Vector3& focus, const Vector3& direction, double half)
    : Shown(Size, Size)
    , Renderer(Shown.addRenderer())
    , Scene(scene)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const Vector3 position = focus + 10.0 * half * direction.normalized();
    camera->SetParallelProjection(true);
    camera->SetParallelScale(half);
    camera->SetFocalPoint(focus.data());
    camera->SetPosition(position.data());
    camera->SetViewUp(0.0, 1.0, 0.2);
    camera->SetClippingRange(5.0 * half, 15.0 * half);
    this->Range = 10.0 * half;
    this->Renderer->AddActor(scene->GetBodyActor());
    this->Renderer->SetBackground(0.97, 0.97, 0.98);
    vtkNew<vtkLight> light; // from the side, so that mirrored normals have a different brightness
    light->SetLightTypeToCameraLight();
    light->SetPosition(0.5, 0.3, 1.0);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddLight(light);
  }

  /// Distance behind the near plane, mm; one per pixel.
  std::vector<float> depths(bool byShader)
  {
    this->render(byShader);
    vtkNew<vtkFloatArray> depths;
    this->Shown.window->GetZbufferData(0, 0, Size - 1, Size - 1, depths);
    std::vector<float> found;
    for (vtkIdType i = 0; i < depths->GetNumberOfTuples(); ++i)
    {
      const float depth = depths->GetTypedComponent(i, 0);
      found.push_back(depth < Background ? static_cast<float>(this->Range) * depth : -1.0F);
    }
    return found;
  }

  /// Red, green, blue, 0 to 255: either the colours of the legend without light, or the light
  /// without colours.
  std::vector<int> colors(bool byShader, bool lit)
  {
    this->Scene->SetDeflectionByShader(byShader);
    vtkActor* actor = this->Scene->GetBodyActor();
    actor->GetProperty()->SetLighting(lit);
    actor->GetMapper()->SetScalarVisibility(!lit);
    this->render(byShader);
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Shown.window->GetPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
    actor->GetProperty()->LightingOn();
    actor->GetMapper()->ScalarVisibilityOn();
    std::vector<int> found;
    for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
    {
      found.push_back(pixels->GetValue(i));
    }
    return found;
  }

  /// The cell under each pixel of a grid, found by vtkHardwareSelector; -1: none.
  std::vector<vtkIdType> cells(bool byShader)
  {
    this->render(byShader);
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(0, 0, Size - 1, Size - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    std::vector<vtkIdType> found;
    if (selector->CaptureBuffers())
    {
      for (unsigned int y = 0; y < Size; y += 3)
      {
        for (unsigned int x = 0; x < Size; x += 3)
        {
          const unsigned int position[2] = { x, y };
          const auto pixel = selector->GetPixelInformation(position);
          found.push_back(pixel.Valid ? pixel.AttributeID : -1);
        }
      }
    }
    selector->ClearBuffers();
    return found;
  }

  /// Returns the picture that a user sees.
  vtkSmartPointer<vtkImageData> picture(bool byShader)
  {
    this->Scene->SetDeflectionByShader(byShader);
    return draw(this->Shown.window);
  }

  vtkRenderer* renderer() { return this->Renderer; }
  vtkRenderWindow* window() { return this->Shown.window; }

private:
  void render(bool byShader)
  {
    this->Scene->SetDeflectionByShader(byShader);
    this->Shown.window->Render();
  }

  Picture Shown;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkContactScene* Scene;
  double Range;
};

/// The largest difference of two measurements, and the fraction of values that differ by more than
/// a tolerance.
struct Deviation
{
  double largest = 0.0;
  double share = 0.0;

  template <class Value>
  Deviation(const std::vector<Value>& one, const std::vector<Value>& other, double tolerance = 0.0)
  {
    PALPATE_CHECK(one.size() == other.size() && !one.empty());
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    {
      const double apart = std::abs(static_cast<double>(one[i]) - static_cast<double>(other[i]));
      this->largest = std::max(this->largest, apart);
      beyond += apart > tolerance ? 1 : 0;
    }
    this->share =
      static_cast<double>(beyond) / static_cast<double>(std::max<std::size_t>(1, one.size()));
  }
};
} // namespace palpate::testing

#endif
