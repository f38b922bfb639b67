// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactScene.h"

#include "DeflectionLegend.h"
#include "DisplayColors.h"
#include "vtkContactDeflection.h"
#include "vtkContactTool.h"
#include "vtkHapticToolRepresentation.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkLightKit.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTriangleMeshPointNormals.h"
#include "vtkTubeFilter.h"
#include "vtkWarpVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double ArrowLength = 40.0; // mm, of the largest force
constexpr double TrailRadius = 0.5;  // mm
constexpr double MarkerRadius = 2.0; // mm
constexpr int CaptionSize = 17;
constexpr double LegendWidth = 175.0; // pixels
constexpr double RaisedFocus = 0.09;  // of the distance, so that the longest arrow fits in

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
double roundDown(double value)
{
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  const double share = value / decade;
  return decade * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}
} // namespace

vtkStandardNewMacro(vtkContactScene);

vtkContactScene::vtkContactScene()
  : Tip(vtkSmartPointer<vtkPolyData>::New())
  , Deflection(vtkSmartPointer<vtkContactDeflection>::New())
  , Warp(vtkSmartPointer<vtkWarpVector>::New())
  , BodyActor(vtkSmartPointer<vtkActor>::New())
  , TrailActor(vtkSmartPointer<vtkActor>::New())
  , Colors(vtkSmartPointer<vtkLookupTable>::New())
  , Legend(vtkSmartPointer<vtkScalarBarActor>::New())
  , Caption(vtkSmartPointer<vtkTextActor>::New())
  , ToolRepresentation(vtkSmartPointer<vtkHapticToolRepresentation>::New())
  , Marker(vtkSmartPointer<vtkActor>::New())
{
  palpate::fillDeflectionColors(this->Colors);
  this->Deflection->SetInputData(1, this->Tip);
  this->Warp->SetInputConnection(this->Deflection->GetOutputPort());
  this->Warp->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "ContactDisplacement");
  vtkNew<vtkTriangleMeshPointNormals> normals;
  normals->SetInputConnection(this->Warp->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("ContactDisplacement");
  mapper->SetLookupTable(this->Colors);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  this->BodyActor->SetMapper(mapper);
  this->TrailActor->GetProperty()->SetColor(
    palpate::TrailColor[0], palpate::TrailColor[1], palpate::TrailColor[2]);
  this->TrailActor->GetProperty()->LightingOff();
  this->TrailActor->VisibilityOff();
  palpate::styleDeflectionLegend(this->Legend, this->Colors, CaptionSize - 2);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(MarkerRadius);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  vtkNew<vtkPolyDataMapper> ballMapper;
  ballMapper->SetInputConnection(ball->GetOutputPort());
  this->Marker->SetMapper(ballMapper);
  this->Marker->GetProperty()->SetColor(
    palpate::ToolColor[0], palpate::ToolColor[1], palpate::ToolColor[2]);
  this->Marker->VisibilityOff();
  this->Caption->GetTextProperty()->SetColor(palpate::TextColor.data());
  this->Caption->GetTextProperty()->SetFontSize(CaptionSize);
  this->Caption->GetTextProperty()->SetLineSpacing(1.2);
  this->Caption->SetPosition(16, 14);
  this->SetLargestDeflection(1.0);
  this->SetLargestForce(1.0);
}

vtkContactScene::~vtkContactScene() = default;

void vtkContactScene::SetRenderer(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  renderer->SetBackground(palpate::BackgroundColor.data());
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.75);
  lights->SetKeyToFillRatio(2.0);
  lights->SetKeyToHeadRatio(2.2);
  lights->AddLightsToRenderer(renderer);
  renderer->AddActor(this->BodyActor);
  renderer->AddActor(this->TrailActor);
  renderer->AddViewProp(this->ToolRepresentation);
  renderer->AddActor(this->Marker);
  renderer->AddViewProp(this->Legend);
  renderer->AddViewProp(this->Caption);
}

void vtkContactScene::SetBody(vtkPolyData* body)
{
  this->Deflection->SetInputData(0, body);
}

void vtkContactScene::SetTool(vtkContactTool* tool)
{
  this->Deflection->SetTool(tool);
  this->ToolRepresentation->SetTool(tool);
}

void vtkContactScene::SetPoissonRatio(double ratio)
{
  this->Deflection->SetPoissonRatio(ratio);
}

void vtkContactScene::SetLargestDeflection(double largest)
{
  this->Colors->SetTableRange(0.0, largest);
}

void vtkContactScene::SetLargestForce(double largest)
{
  this->ToolRepresentation->SetForceScale(roundDown(ArrowLength / largest));
}

void vtkContactScene::SetExaggeration(double factor)
{
  this->Warp->SetScaleFactor(factor);
}

double vtkContactScene::GetExaggeration()
{
  return this->Warp->GetScaleFactor();
}

void vtkContactScene::SetTitle(const std::string& title)
{
  this->Title = title;
}

void vtkContactScene::SetRemark(const std::string& remark)
{
  this->Remark = remark;
}

void vtkContactScene::SetBlind(bool blind)
{
  this->Blind = blind;
  this->ToolRepresentation->SetVisibility(!blind);
  this->Legend->SetVisibility(!blind);
  this->Marker->SetVisibility(blind);
}

bool vtkContactScene::ShowTrail(vtkPolyData* probed)
{
  vtkDataArray* contact = probed->GetPointData()->GetArray("ContactPoint");
  vtkDataArray* cell = probed->GetPointData()->GetArray("ContactCell");
  if (!contact || !cell)
  {
    vtkErrorMacro(<< "A trail needs the output of a vtkToolContactProbe.");
    return false;
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(0);
  for (vtkIdType i = 0; i < contact->GetNumberOfTuples(); ++i)
  {
    if (cell->GetTuple1(i) >= 0.0)
    {
      line->InsertCellPoint(points->InsertNextPoint(contact->GetTuple3(i)));
    }
  }
  line->UpdateCellCount(static_cast<int>(points->GetNumberOfPoints()));
  vtkNew<vtkPolyData> trail;
  trail->SetPoints(points);
  trail->SetLines(line);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(trail);
  tube->SetRadius(TrailRadius);
  tube->SetNumberOfSides(12);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  this->TrailActor->SetMapper(mapper);
  this->TrailActor->SetVisibility(points->GetNumberOfPoints() > 1);
  return true;
}

bool vtkContactScene::ShowTip(vtkPolyData* probed, vtkIdType index)
{
  vtkPointData* data = probed->GetPointData();
  vtkDataArray* force = data->GetArray("Force");
  vtkDataArray* normal = data->GetArray("Normal");
  vtkDataArray* contact = data->GetArray("ContactPoint");
  vtkDataArray* deflection = data->GetArray("Deflection");
  vtkDataArray* cell = data->GetArray("ContactCell");
  if (!force || !normal || !contact || !deflection || !cell || index < 0 ||
    index >= probed->GetNumberOfPoints())
  {
    vtkErrorMacro(<< "Tip " << index << " of " << probed->GetNumberOfPoints()
                  << ": not a tip of a vtkToolContactProbe's output.");
    return false;
  }
  std::array<double, 3> tip{};
  std::array<double, 3> forceNow{};
  std::array<double, 3> normalNow{};
  std::array<double, 3> contactNow{};
  probed->GetPoint(index, tip.data());
  force->GetTuple(index, forceNow.data());
  normal->GetTuple(index, normalNow.data());
  contact->GetTuple(index, contactNow.data());
  this->ShowContact(tip.data(), contactNow.data(), normalNow.data(), forceNow.data(),
    deflection->GetTuple1(index), static_cast<vtkIdType>(cell->GetTuple1(index)));
  return true;
}

void vtkContactScene::ShowContact(const double tip[3], const double contactPoint[3],
  const double normal[3], const double force[3], double deflection, vtkIdType cell)
{
  if (this->Blind)
  {
    // On the surface: how deep the hand gets would tell how hard the body pushes back.
    const double* place = cell < 0 ? tip : contactPoint;
    this->Marker->SetPosition(place[0], place[1], place[2]);
    this->WriteCaption("");
    cell = -1; // no dent
  }
  else
  {
    this->ToolRepresentation->SetContact(tip, normal, contactPoint, force);
    this->PlaceLegend();
    this->DescribeContact(deflection, vtkMath::Norm(force));
  }
  vtkDataArray* shown = this->Tip->GetPointData()->GetArray("ContactCell");
  if (cell < 0 && shown && shown->GetTuple1(0) < 0.0)
  {
    return; // no dent before, none now: the body need not be drawn anew
  }
  std::copy_n(contactPoint, 3, this->Contact);
  vtkNew<vtkPoints> point;
  point->SetDataTypeToDouble();
  point->InsertNextPoint(tip);
  this->Tip->SetPoints(point);
  const auto store = [this](const char* name, int components, const double* value)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->InsertNextTuple(value);
    this->Tip->GetPointData()->AddArray(array);
  };
  const auto cellNumber = static_cast<double>(cell);
  store("Deflection", 1, &deflection);
  store("Normal", 3, normal);
  store("ContactPoint", 3, contactPoint);
  store("ContactCell", 1, &cellNumber);
  this->Tip->Modified();
}

void vtkContactScene::SetFieldRadius(double radius)
{
  this->Deflection->SetMaximumDistance(radius);
}

double vtkContactScene::GetLegendShare()
{
  // The same size in pixels, however narrow the viewport.
  const int width = this->Renderer ? std::max(this->Renderer->GetSize()[0], 1) : 1;
  return std::min(1.0, LegendWidth / static_cast<double>(width));
}

void vtkContactScene::PlaceLegend()
{
  const double share = this->GetLegendShare(); // at the right edge
  this->Legend->GetPositionCoordinate()->SetValue(1.0 - share, 0.25);
  this->Legend->SetWidth(0.85 * share);
}

void vtkContactScene::DescribeContact(double deflection, double force)
{
  std::array<char, 256> text{};
  vtkContactTool* tool = this->ToolRepresentation->GetTool();
  const double scale = this->ToolRepresentation->GetForceScale();
  std::snprintf(text.data(), text.size(),
    "Tool: %s\nDeflection %.2f mm, force %#.3g N\nForce arrow: 10 mm = %.3g N",
    tool ? tool->GetDescription().c_str() : "", deflection, force, 10.0 / scale);
  std::string caption = text.data();
  if (this->GetExaggeration() != 1.0)
  {
    std::snprintf(text.data(), text.size(), "\nDent drawn x%.3g", this->GetExaggeration());
    caption += text.data();
  }
  this->WriteCaption(caption);
}

void vtkContactScene::WriteCaption(const std::string& contact)
{
  std::string caption;
  for (const std::string& part : { this->Title, contact, this->Remark })
  {
    caption += caption.empty() || part.empty() ? part : "\n" + part;
  }
  this->Caption->SetInput(caption.c_str());
}

void vtkContactScene::LookAtBody(const double direction[3], const double up[3])
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  double bounds[6];
  this->Deflection->Update();
  vtkBoundingBox all(this->Deflection->GetOutput()->GetBounds());
  const double* tool = this->ToolRepresentation->GetBounds();
  if (tool && !this->Blind)
  {
    all.AddBounds(tool); // with the arrow: neither is to be cut off
  }
  all.GetBounds(bounds);
  double position[3];
  double focus[3];
  for (int k = 0; k < 3; ++k)
  {
    focus[k] = 0.5 * (bounds[2 * k] + bounds[2 * k + 1]);
    position[k] = focus[k] + direction[k];
  }
  camera->SetFocalPoint(focus);
  camera->SetPosition(position);
  camera->SetViewUp(up);
  this->Renderer->ResetCamera(bounds);
  camera->Zoom(1.15);
  camera->SetWindowCenter(this->GetLegendShare(), 0.0); // the middle of what the legend leaves free
  this->Renderer->ResetCameraClippingRange();
}

void vtkContactScene::LookAtContact(double distance, const double direction[3], const double up[3])
{
  double unit[3] = { direction[0], direction[1], direction[2] };
  vtkMath::Normalize(unit);
  double raise[3] = { up[0], up[1], up[2] };
  vtkMath::Normalize(raise);
  double focus[3];
  double position[3];
  for (int k = 0; k < 3; ++k)
  {
    focus[k] = this->Contact[k] + RaisedFocus * distance * raise[k];
    position[k] = focus[k] + distance * unit[k];
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(focus);
  camera->SetPosition(position);
  camera->SetViewUp(up);
  camera->SetWindowCenter(this->GetLegendShare(), 0.0);
  this->Renderer->ResetCameraClippingRange();
}

vtkHapticToolRepresentation* vtkContactScene::GetToolRepresentation()
{
  return this->ToolRepresentation;
}

vtkActor* vtkContactScene::GetBodyActor()
{
  return this->BodyActor;
}

vtkScalarBarActor* vtkContactScene::GetLegend()
{
  return this->Legend;
}

void vtkContactScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "Blind: " << this->Blind << "\n";
  os << indent << "Exaggeration: " << this->GetExaggeration() << "\n";
}
