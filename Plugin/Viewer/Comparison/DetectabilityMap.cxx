// SPDX-License-Identifier: BSD-3-Clause
#include "DetectabilityMap.h"

#include "Interaction/Display/RoundSteps.h"
#include "Mechanics/JoinedText.h"
#include "MapColors.h"
#include "MapStage.h"
#include "PhantomBody.h"

#include "vtkActor.h"
#include "vtkContourFilter.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr double PerceptibleChange = 10.0; // %, the default of vtkNoduleDetectability
constexpr double ViewMargin = 7.0;         // margin around the body in the view, mm
constexpr std::size_t MostMaps = 3;
// Exponent of the colour scale that makes small changes distinguishable.
constexpr double CurveOfColors = 0.5;

/// Returns a body with the change of the force for one tool, in per cent, as point scalars.
vtkSmartPointer<vtkPolyData> changeOf(vtkPolyData* body, int tool)
{
  vtkDataArray* change = body->GetPointData()->GetArray("ForceChange");
  auto shown = vtkSmartPointer<vtkPolyData>::New();
  shown->CopyStructure(body);
  vtkNew<vtkFloatArray> percent;
  percent->SetName("Change");
  percent->SetNumberOfTuples(change->GetNumberOfTuples());
  for (vtkIdType i = 0; i < change->GetNumberOfTuples(); ++i)
  {
    percent->SetValue(i, static_cast<float>(100.0 * change->GetComponent(i, tool)));
  }
  shown->GetPointData()->SetScalars(percent);
  return shown;
}

/// Returns the largest change for any tool, in per cent, rounded up to a round step of the legend.
double largestOf(vtkPolyData* body)
{
  vtkDataArray* change = body->GetPointData()->GetArray("ForceChange");
  double largest = PerceptibleChange;
  for (int tool = 0; tool < change->GetNumberOfComponents(); ++tool)
  {
    std::array<double, 2> range{};
    change->GetFiniteRange(range.data(), tool);
    largest = std::max(largest, 100.0 * range[1]);
  }
  const double step = roundStep(largest, 6);
  return step * std::ceil(largest / step);
}

void addChange(MapStage& stage, vtkPolyData* shown, vtkLookupTable* colors,
  const MapStage::Viewport& viewport, const std::string& title)
{
  vtkRenderer* renderer = stage.addRenderer(viewport);
  addColoredBody(shown, colors, "Change of force\n(%)\n ", "%.0f", renderer);
  vtkNew<vtkContourFilter> lines;
  lines->SetInputData(shown);
  lines->SetValue(0, PerceptibleChange);
  vtkNew<vtkPolyDataMapper> lineMapper;
  lineMapper->SetInputConnection(lines->GetOutputPort());
  lineMapper->ScalarVisibilityOff();
  lineMapper->SetResolveCoincidentTopologyToPolygonOffset();
  lineMapper->SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -4.0);
  vtkNew<vtkActor> line;
  line->SetMapper(lineMapper);
  line->GetProperty()->SetColor(0.0, 0.0, 0.0);
  line->GetProperty()->SetLineWidth(2.0F);
  line->GetProperty()->LightingOff();
  renderer->AddActor(line);
  stage.addTitle(title);
}

/// Describes the change above each nodule in one line per nodule. `inShort` selects short lines for
/// a picture.
std::string describeNodules(const ViewerScene& scene, bool inShort)
{
  vtkPointData* data = scene.body->GetPointData();
  vtkDataArray* change = data->GetArray("ForceChange");
  vtkDataArray* depth = data->GetArray("ChangeDepth");
  std::string text = inShort
    ? "Change of the force by each nodule;\nin brackets: not felt\n \n"
    : "Change of the force over each nodule (and the depth of the largest change):\n";
  for (std::size_t i = 0; i < scene.tools.size(); ++i)
  {
    text += (i > 0 ? ", " : "radius, depth of the top: ") + scene.tools[i];
  }
  for (const PhantomNodule& nodule : PhantomNodules)
  {
    const vtkIdType point = scene.body->vtkDataSet::FindPoint(nodule.x, nodule.y, 0.0);
    std::array<char, 80> words{};
    std::snprintf(
      words.data(), words.size(), "\n%3.1f mm, %.0f mm deep:", nodule.radius, nodule.top);
    text += words.data();
    for (int tool = 0; tool < change->GetNumberOfComponents(); ++tool)
    {
      const double percent = 100.0 * change->GetComponent(point, tool);
      const bool isFelt = std::abs(percent) >= PerceptibleChange;
      const char* comma = tool > 0 ? ", " : " ";
      if (inShort)
      {
        std::snprintf(words.data(), words.size(), "%s%s%+.0f %%%s", comma, isFelt ? "" : "(",
          percent, isFelt ? "" : ")");
      }
      else
      {
        std::snprintf(words.data(), words.size(), "%s%+.1f %% (%.2f mm)%s", comma, percent,
          depth->GetComponent(point, tool), isFelt ? "" : ", not felt");
      }
      text += words.data();
    }
    const double strongest = data->GetArray("StrongestTool")->GetTuple1(point);
    if (!inShort && change->GetNumberOfComponents() > 1 && strongest >= 0.0)
    {
      text += "; most " + scene.tools[static_cast<std::size_t>(strongest)];
    }
  }
  return text;
}
} // namespace

std::string runDetectabilityMap(const ViewerOptions& options, const ViewerScene& scene)
{
  const std::size_t maps = std::min(scene.tools.size(), MostMaps);
  MapStage stage("Palpate: " + scene.title, options.window);
  const vtkSmartPointer<vtkLookupTable> colors =
    makeMapColors({ 0.0, largestOf(scene.body) }, CurveOfColors);
  const std::array<MapStage::Viewport, 4> places = { { { 0.0, 0.5, 0.5, 1.0 },
    { 0.5, 0.5, 1.0, 1.0 }, { 0.0, 0.0, 0.5, 0.5 }, { 0.5, 0.0, 1.0, 0.5 } } };
  const std::array<MapStage::Viewport, 2> alone = { { { 0.0, 0.0, 0.62, 1.0 },
    { 0.62, 0.0, 1.0, 1.0 } } };
  for (std::size_t i = 0; i < maps; ++i)
  {
    addChange(stage, changeOf(scene.body, static_cast<int>(i)), colors,
      maps == 1 ? alone[0] : places[i], scene.tools[i]);
  }
  const std::string all = joined(scene.title, "\npressed up to ", scene.depth,
    " mm deep\nlined: from ", PerceptibleChange,
    " %, the least that a hand feels\ngrey: not searched, so no force is known there\n \n",
    describeNodules(scene, true));
  stage.addWords(all, maps == 1 ? alone[1] : places[maps]);
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(PhantomField[0] - ViewMargin, PhantomField[2] - ViewMargin, 0.0);
  corners->InsertNextPoint(PhantomField[1] + ViewMargin, PhantomField[3] + ViewMargin, 0.0);
  vtkNew<vtkPolyData> field;
  field->SetPoints(corners);
  stage.lookFrom(field, scene.viewFrom, scene.up);
  std::printf("%s\n%s\n", scene.title.c_str(), describeNodules(scene, false).c_str());
  return stage.show(options);
}
} // namespace palpate
