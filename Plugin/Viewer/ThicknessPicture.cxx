// SPDX-License-Identifier: BSD-3-Clause
#include "ThicknessPicture.h"

#include "PictureSize.h"
#include "Pictures.h"
#include "Interaction/Display/SceneView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLayerThickness.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate
{
namespace
{
constexpr int TableSize = 256;
constexpr int ScaleTextSize = 17;
constexpr double LegendStep = 2.0; // step of the legend, mm
constexpr double HeadZoom = 1.45;

constexpr Color Unknown = { 0.62, 0.62, 0.64 };

// Colours from thin to thick. They are those of viridis, whose lightness increases monotonically.
constexpr std::array<Color, 5> Scale = { { { 0.267, 0.005, 0.329 }, { 0.229, 0.322, 0.546 },
  { 0.128, 0.567, 0.551 }, { 0.369, 0.789, 0.383 }, { 0.993, 0.906, 0.144 } } };

/// Returns the thickness at points with a layer, and NaN at other points.
vtkSmartPointer<vtkFloatArray> knownThickness(vtkDataArray* thickness)
{
  auto found = vtkSmartPointer<vtkFloatArray>::New();
  found->SetName("Shown");
  found->SetNumberOfTuples(thickness->GetNumberOfTuples());
  for (vtkIdType i = 0; i < thickness->GetNumberOfTuples(); ++i)
  {
    const auto here = static_cast<float>(thickness->GetTuple1(i));
    found->SetValue(i, here > 0.0F ? here : std::numeric_limits<float>::quiet_NaN());
  }
  return found;
}

/// Makes a lookup table whose range extends from the smallest to the largest thickness, rounded to
/// steps of the legend.
vtkSmartPointer<vtkLookupTable> makeColors(vtkDataArray* found)
{
  std::array<double, 2> range{};
  found->GetFiniteRange(range.data());
  auto colors = vtkSmartPointer<vtkLookupTable>::New();
  colors->SetNumberOfTableValues(TableSize);
  for (int i = 0; i < TableSize; ++i)
  {
    const double position = static_cast<double>(Scale.size() - 1) * i / (TableSize - 1);
    const auto left = std::min(static_cast<std::size_t>(position), Scale.size() - 2);
    const double share = position - static_cast<double>(left);
    Color color{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      color[k] = (1.0 - share) * Scale[left][k] + share * Scale[left + 1][k];
    }
    colors->SetTableValue(i, color[0], color[1], color[2]);
  }
  const double first = LegendStep * std::floor(std::min(range[0], range[1]) / LegendStep);
  const double last = LegendStep * std::ceil(range[1] / LegendStep);
  colors->SetTableRange(first, std::max(last, first + LegendStep));
  colors->SetNanColor(Unknown[0], Unknown[1], Unknown[2], 1.0);
  return colors;
}

void style(vtkTextProperty* text)
{
  text->SetColor(TextColor.data());
  text->SetFontSize(ScaleTextSize);
  text->SetBold(0);
  text->SetItalic(0);
  text->SetShadow(0);
}

/// Adds a view of the body in a part of the window.
vtkSmartPointer<vtkRenderer> addView(
  vtkRenderWindow* window, vtkActor* body, double left, double right)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(left, 0.0, right, 1.0);
  renderer->UseFXAAOn();
  lightScene(renderer);
  renderer->AddActor(body);
  window->AddRenderer(renderer);
  return renderer;
}

void lookFrom(vtkRenderer* renderer, vtkPolyData* body, const Direction& from, const Direction& up)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  Direction centre{};
  body->GetCenter(centre.data());
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(centre[0] + from[0], centre[1] + from[1], centre[2] + from[2]);
  camera->SetViewUp(up.data());
  renderer->ResetCamera(body->GetBounds());
  // Zooms in, because ResetCamera fits the sphere around the body, which is larger than the body.
  camera->Zoom(HeadZoom);
  renderer->ResetCameraClippingRange();
}
} // namespace

std::string drawThickness(const std::string& file, const ViewerScene& scene)
{
  const vtkSmartPointer<vtkFloatArray> found =
    knownThickness(scene.body->GetPointData()->GetArray("LayerThickness"));
  const vtkSmartPointer<vtkLookupTable> colors = makeColors(found);
  vtkNew<vtkPolyData> shown;
  shown->ShallowCopy(scene.body);
  shown->GetPointData()->AddArray(found);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shown);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Shown");
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  // Colours are interpolated instead of values, because no value exists between "no bone" and a
  // thickness.
  mapper->InterpolateScalarsBeforeMappingOff();
  vtkNew<vtkActor> body;
  body->SetMapper(mapper);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0); // without multisampling, the pixels are the same on every machine
  window->SetSize(PictureWidth, PictureHeight);
  const vtkSmartPointer<vtkRenderer> near = addView(window, body, 0.0, 0.5);
  const vtkSmartPointer<vtkRenderer> far = addView(window, body, 0.5, 1.0);
  const Direction& from = scene.viewFrom;
  lookFrom(near, scene.body, from, scene.up);
  lookFrom(far, scene.body, { -from[0], -from[1], from[2] }, scene.up);

  vtkNew<vtkScalarBarActor> legend;
  legend->SetLookupTable(colors);
  legend->SetTitle("Soft tissue over bone (mm)\n ");
  legend->SetOrientationToHorizontal();
  const double* range = colors->GetTableRange();
  legend->SetNumberOfLabels(static_cast<int>(std::lround((range[1] - range[0]) / LegendStep)) + 1);
  legend->SetLabelFormat("%.0f");
  legend->UnconstrainedFontSizeOn();
  style(legend->GetTitleTextProperty());
  style(legend->GetLabelTextProperty());
  legend->GetPositionCoordinate()->SetValue(0.1, 0.02);
  legend->SetWidth(0.8);
  legend->SetHeight(0.11);
  far->AddViewProp(legend);

  vtkNew<vtkTextActor> caption;
  std::array<char, 200> text{};
  vtkNew<vtkLayerThickness> settings;
  std::snprintf(text.data(), text.size(),
    "%s\nThickness of the %s, along the normal\nGrey: no bone within %g mm, %s",
    scene.title.c_str(), scene.layer.isStack() ? "layers" : "layer", settings->GetMaximumDepth(),
    scene.layer.isStack() ? "taken to be that deep" : "a half-space");
  caption->SetInput(text.data());
  style(caption->GetTextProperty());
  caption->GetTextProperty()->SetLineSpacing(1.2);
  caption->SetPosition(16, 14);
  near->AddViewProp(caption);
  return writePicture(window, file);
}
} // namespace palpate
