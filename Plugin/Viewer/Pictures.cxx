// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures.h"

#include "Contact/ResponseContract.h"
#include "LayerModel.h"
#include "MeasuredReadings.h"
#include "PictureSize.h"
#include "Interaction/Display/WindowPicture.h"

#include "vtkActor.h"
#include "vtkChartXY.h"
#include "vtkContactScene.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkResponseChart.h"
#include "vtkResponseCurves.h"
#include "vtkToolContactProbe.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double CloseUpDistance = 120.0; // distance of the camera for the close-up, mm

/// Adds the marks of the scene, which are lines on the body, to a renderer.
void addMarks(const ViewerScene& scene, vtkRenderer* renderer)
{
  if (!scene.marks)
  {
    return;
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(scene.marks);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -4.0);
  vtkNew<vtkActor> lines;
  lines->SetMapper(mapper);
  lines->GetProperty()->SetColor(0.0, 0.0, 0.0);
  lines->GetProperty()->SetLineWidth(2.0F);
  lines->GetProperty()->LightingOff();
  renderer->AddActor(lines);
}

/// Returns the remark. If the scene has marks, a line that explains them is added above the remark.
std::string withMarks(const ViewerScene& scene, const std::string& remark)
{
  return scene.marksInWords + (scene.marksInWords.empty() || remark.empty() ? "" : "\n") + remark;
}

/// A window that shows one or more contact scenes.
struct Stage
{
  vtkNew<vtkRenderWindow> window;

  explicit Stage(int width = PictureWidth)
  {
    this->window->SetOffScreenRendering(1);
    // Without multisampling, the pixels are the same on every machine.
    this->window->SetMultiSamples(0);
    this->window->SetSize(width, PictureHeight);
  }

  vtkSmartPointer<vtkContactScene> addScene(const ViewerScene& scene, vtkPolyData* body,
    vtkContactTool* tool, const PicturedMoment& moment, double largestForce, double left,
    double right)
  {
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(left, 0.0, right, 1.0);
    renderer->UseFXAAOn();
    this->window->AddRenderer(renderer);
    auto shown = vtkSmartPointer<vtkContactScene>::New();
    shown->SetRenderer(renderer);
    shown->SetBody(body);
    shown->SetTool(tool);
    shown->SetPoissonRatio(scene.poissonRatio);
    shown->SetLargestForce(largestForce);
    shown->SetLargestDeflection(scene.depth);
    shown->SetTitle(scene.title + describeSpot(scene, nearestCorner(body, moment)));
    shown->SetRemark(withMarks(scene, moment.remark));
    addMarks(scene, renderer);
    return shown;
  }
};

struct View
{
  Direction from;
  Direction up;
};

/// Returns a view in which the tool is upright, from slightly above the surface, on the side of
/// `viewFrom`.
View viewOfTool(const PicturedMoment& moment, const Direction& viewFrom)
{
  View view{};
  moment.recording->GetPointData()->GetArray("Normal")->GetTuple(moment.tick, view.up.data());
  const double along = vtkMath::Dot(viewFrom.data(), view.up.data());
  Direction side{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    side[k] = viewFrom[k] - along * view.up[k];
  }
  if (vtkMath::Normalize(side.data()) == 0.0)
  {
    Direction other{};
    vtkMath::Perpendiculars(view.up.data(), side.data(), other.data(), 0.0);
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    view.from[k] = 0.5 * view.up[k] + 0.87 * side[k];
  }
  return view;
}
} // namespace

std::vector<vtkIdType> picturedPoints(vtkPolyData* body, const PicturedMoment& moment)
{
  const auto cell = static_cast<vtkIdType>(
    moment.recording->GetPointData()->GetArray("ContactCell")->GetTuple1(moment.tick));
  if (cell < 0)
  {
    return { 0 };
  }
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(cell, corners);
  return { corners->begin(), corners->end() };
}

vtkIdType nearestCorner(vtkPolyData* body, const PicturedMoment& moment)
{
  Direction contact{};
  moment.recording->GetPointData()->GetArray("ContactPoint")->GetTuple(moment.tick, contact.data());
  const auto distance = [&](vtkIdType id)
  {
    Direction point{};
    body->GetPoint(id, point.data());
    return vtkMath::Distance2BetweenPoints(point.data(), contact.data());
  };
  const std::vector<vtkIdType> corners = picturedPoints(body, moment);
  return *std::min_element(corners.begin(), corners.end(),
    [&](vtkIdType a, vtkIdType b) { return distance(a) < distance(b); });
}

void fitToScreen(vtkRenderWindow* window)
{
  constexpr int taken = 60; // height of the window's title and the desktop's bar, pixels
  const int* screen = window->GetScreenSize();
  const auto fitted = [](int wished, int available)
  { return available > 0 ? std::min(wished, available) : wished; };
  window->SetSize(fitted(PictureWidth, screen[0]), fitted(PictureHeight, screen[1] - taken));
}

std::string writePicture(vtkRenderWindow* window, const std::string& file)
{
  window->Render();
  return writeWindowPicture(window, file);
}

std::string drawContact(const std::string& closeUp, const std::string& overview,
  const ViewerScene& scene, const ResponseSet& responses, const PicturedMoment& moment)
{
  Stage stage;
  auto shown = stage.addScene(
    scene, responses.body, responses.tools.front(), moment, moment.largestForce, 0.0, 1.0);
  shown->ShowTip(moment.recording, moment.tick);
  const View view = viewOfTool(moment, scene.viewFrom);
  shown->LookAtContact(CloseUpDistance, view.from.data(), view.up.data());
  const std::string error = writePicture(stage.window, closeUp);
  if (!error.empty())
  {
    return error;
  }
  shown->ShowTrail(moment.recording);
  shown->LookAtBody(scene.viewFrom.data(), scene.up.data());
  return writePicture(stage.window, overview);
}

std::string drawSideBySide(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment)
{
  vtkNew<vtkPolyData> tip;
  vtkNew<vtkPoints> point;
  point->SetDataTypeToDouble();
  point->InsertNextPoint(moment.recording->GetPoint(moment.tick));
  tip->SetPoints(point);

  const std::size_t count = responses.tools.size();
  std::vector<vtkSmartPointer<vtkPolyData>> probed;
  double largestForce = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    vtkNew<vtkToolContactProbe> probe;
    probe->SetInputData(0, responses.body);
    probe->SetTipData(tip);
    probe->SetResponseName(responses.names[i]);
    const std::string error = updateQuietly(probe);
    if (!error.empty())
    {
      return error;
    }
    probed.emplace_back(probe->GetOutput());
    largestForce = std::max(
      largestForce, probe->GetOutput()->GetPointData()->GetArray("NormalForce")->GetTuple1(0));
  }
  Stage stage(static_cast<int>(count) * PictureWidth / 2);
  std::vector<vtkSmartPointer<vtkContactScene>> scenes;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double share = 1.0 / static_cast<double>(count);
    auto shown = stage.addScene(scene, responses.body, responses.tools[i], moment, largestForce,
      static_cast<double>(i) * share, static_cast<double>(i + 1) * share);
    shown->SetResponseName(responses.names[i]);
    shown->SetRemark(withMarks(scene,
      i == 0 ? moment.remark
             : std::string())); // only once, because the peak is that of the first tool
    shown->ShowTip(probed[i], 0);
    shown->LookAtContact(1.2 * CloseUpDistance, scene.viewFrom.data(), scene.up.data());
    scenes.push_back(shown);
  }
  return writePicture(stage.window, file);
}

std::string drawCurves(const std::string& file, const ViewerScene& scene,
  const ResponseSet& responses, const PicturedMoment& moment)
{
  const vtkIdType point = nearestCorner(responses.body, moment);
  vtkNew<vtkResponseChart> chart;
  chart->SetTitle(
    scene.title + describeSpot(scene, point) + ": tools at one point (dotted: beyond validity)");
  for (std::size_t i = 0; i < responses.tools.size(); ++i)
  {
    vtkNew<vtkResponseCurves> curves;
    curves->SetInputData(responses.body);
    curves->SetResponseName(responses.names[i]);
    curves->AddPointId(point);
    const std::string error = updateQuietly(curves);
    if (!error.empty())
    {
      return error;
    }
    const double valid =
      responses.body->GetPointData()
        ->GetArray(palpate::arrayName(responses.names[i], palpate::ResponseArray::Validity).c_str())
        ->GetTuple1(point);
    chart->AddCurve(
      curves->GetOutput(), responses.tools[i]->GetDescription() + measuredLabel(scene), valid);
  }
  addReadings(scene, chart);
  vtkNew<vtkContextView> view;
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetMultiSamples(0);
  view->GetRenderWindow()->SetSize(PictureWidth, PictureHeight);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  view->GetScene()->AddItem(chart->GetChart());
  return writePicture(view->GetRenderWindow(), file);
}
} // namespace palpate
