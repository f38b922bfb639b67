// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/ComparisonColumn.h"

#include "Interaction/Display/DisplayColors.h"
#include "Response/BodyRegime.h"
#include "vtkContactScene.h"
#include "vtkContactTool.h"
#include "vtkHapticSession.h"
#include "vtkHapticToolRepresentation.h"
#include "vtkRegimeMap.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palpate
{
namespace
{
// Heights of the parts, as fractions of the column's height.
constexpr double PanelTop = 0.115;
constexpr double ChartTop = 0.46;
constexpr int TitleSize = 19;
// The scale of the arrow is unchanged while the force changes by less than this factor.
constexpr double SameScale = 4.0;

/// Returns the corner of a cell that is nearest to `place`.
vtkIdType nearestCorner(vtkPolyData* body, vtkIdType cell, const double place[3])
{
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(cell, corners);
  vtkIdType best = -1;
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
  {
    std::array<double, 3> corner{};
    body->GetPoint(corners->GetId(i), corner.data());
    const double distance = vtkMath::Distance2BetweenPoints(corner.data(), place);
    if (distance < least)
    {
      least = distance;
      best = corners->GetId(i);
    }
  }
  return best;
}

double largestForce(const RegimeStatement& statement)
{
  double largest = 0.0;
  for (const ToolRegime& tool : statement.tools)
  {
    largest = std::max(largest, tool.force);
  }
  return largest;
}
} // namespace

ComparisonColumn::ComparisonColumn()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Scene(vtkSmartPointer<vtkContactScene>::New())
  , Map(vtkSmartPointer<vtkRegimeMap>::New())
  , Title(vtkSmartPointer<vtkTextActor>::New())
{
  this->Renderer->UseFXAAOn();
  this->Scene->SetRenderer(this->Renderer);
  // The applied force is hidden, because the bodies are compared, not the forces that a device can
  // render.
  this->Scene->GetToolRepresentation()->SetAppliedForceVisibility(false);
  this->Scene->SetTrailVisibility(false);
  this->Map->SetVisibility(false);
  this->Map->SetRenderer(this->Renderer);
  this->Title->GetTextProperty()->SetColor(TextColor.data());
  this->Title->GetTextProperty()->SetFontSize(TitleSize);
  this->Title->GetTextProperty()->SetBold(1);
  this->Title->GetTextProperty()->SetVerticalJustificationToTop();
  this->Title->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Title->GetPositionCoordinate()->SetValue(0.02, 0.975);
  this->Renderer->AddViewProp(this->Title);
  // The clipping range is reset before each rendering, because the camera is shared with another
  // body, which has other bounds.
  vtkNew<vtkCallbackCommand> fit;
  fit->SetCallback([](vtkObject* renderer, unsigned long, void*, void*)
    { static_cast<vtkRenderer*>(renderer)->ResetCameraClippingRange(); });
  this->Renderer->AddObserver(vtkCommand::StartEvent, fit);
}

ComparisonColumn::~ComparisonColumn() = default;

void ComparisonColumn::addTo(vtkRenderWindow* window, double left, double right)
{
  this->Renderer->SetViewport(left, ChartTop, right, 1.0);
  window->AddRenderer(this->Renderer);
  this->Chart.addTo(window, { left, PanelTop, right, ChartTop });
  this->Panel.addTo(window, { left, 0.0, right, PanelTop });
}

void ComparisonColumn::setBody(vtkPolyData* body, const std::string& title)
{
  this->Body = body;
  this->JudgedPoint = -1;
  this->MapIsMade = false;
  this->Scene->SetBody(body);
  this->Title->SetInput(title.c_str());
}

void ComparisonColumn::setTools(const std::vector<ComparedTool>& tools)
{
  this->Tools = tools;
  this->JudgedPoint = -1;
  this->MapIsMade = false;
}

void ComparisonColumn::setMaterial(const ComparedMaterial& material)
{
  this->Material = material;
  this->JudgedPoint = -1;
  this->MapIsMade = false;
  this->Scene->SetPoissonRatio(material.poissonRatio);
}

void ComparisonColumn::setDeflection(double deflection)
{
  this->Deflection = deflection;
  this->JudgedPoint = -1;
  this->MapIsMade = false;
  this->Scene->SetLargestDeflection(deflection);
}

void ComparisonColumn::setShownTool(std::size_t tool)
{
  this->ShownTool = tool;
  this->MapIsMade = false;
  this->Scene->SetTool(this->Tools[tool].tool);
  this->Scene->SetResponseName(this->Tools[tool].responseName);
}

vtkPolyData* ComparisonColumn::body()
{
  return this->Body;
}

vtkRenderer* ComparisonColumn::renderer()
{
  return this->Renderer;
}

vtkContactScene* ComparisonColumn::scene()
{
  return this->Scene;
}

vtkRegimeMap* ComparisonColumn::map()
{
  return this->Map;
}

std::string ComparisonColumn::showTip(vtkPolyData* probed, vtkIdType index)
{
  vtkPointData* data = probed ? probed->GetPointData() : nullptr;
  vtkDataArray* cell = data ? data->GetArray("ContactCell") : nullptr;
  vtkDataArray* place = data ? data->GetArray("ContactPoint") : nullptr;
  vtkDataArray* deflection = data ? data->GetArray("Deflection") : nullptr;
  vtkDataArray* force = data ? data->GetArray("NormalForce") : nullptr;
  if (!cell || !place || !deflection || !force || index < 0 || index >= probed->GetNumberOfPoints())
  {
    return "there is no tip " + std::to_string(index) + " with the arrays of vtkToolContactProbe";
  }
  std::array<double, 3> contact{};
  place->GetTuple(index, contact.data());
  const std::string error = this->followContact(static_cast<vtkIdType>(cell->GetTuple1(index)),
    contact.data(), deflection->GetTuple1(index), force->GetTuple1(index));
  if (error.empty())
  {
    this->Scene->ShowTip(probed, index);
  }
  return error;
}

std::string ComparisonColumn::showSession(vtkHapticSession* session)
{
  std::array<double, 3> contact{};
  std::array<double, 3> force{};
  std::array<double, 3> friction{};
  session->GetContactPoint(contact.data());
  session->GetIdealForce(force.data());
  session->GetFrictionForce(friction.data());
  vtkMath::Subtract(force, friction, force);
  const std::string error = this->followContact(session->GetContactCell(), contact.data(),
    session->GetDeflection(), vtkMath::Norm(force.data()));
  this->Scene->ShowSession(session);
  return error;
}

std::string ComparisonColumn::followContact(
  vtkIdType cell, const double contact[3], double deflection, double normalForce)
{
  if (!this->Body)
  {
    return "there is no body";
  }
  if (cell < 0)
  {
    this->Chart.mark(0.0, 0.0);
    return {};
  }
  this->Chart.mark(deflection, normalForce);
  return this->judge(nearestCorner(this->Body, cell, contact));
}

std::string ComparisonColumn::showPlace(const double place[3])
{
  return this->Body ? this->judge(this->Body->vtkDataSet::FindPoint(place[0], place[1], place[2]))
                    : "there is no body";
}

std::string ComparisonColumn::judge(vtkIdType point)
{
  if (this->Tools.empty())
  {
    return "there is no tool";
  }
  if (point == this->JudgedPoint || point < 0)
  {
    return {};
  }
  std::string error =
    judgePoint(this->Body, point, this->Tools, this->Material, this->Deflection, this->Statement);
  if (error.empty())
  {
    error = this->Chart.drawCurves(this->Body, point, this->Tools, this->Statement.deflection);
  }
  if (error.empty())
  {
    this->JudgedPoint = point;
    this->Panel.show(this->Statement);
    this->fitArrow();
  }
  return error;
}

void ComparisonColumn::fitArrow()
{
  const double largest = largestForce(this->Statement);
  const bool fits =
    largest < SameScale * this->ArrowForce && largest * SameScale > this->ArrowForce;
  if (largest > 0.0 && !fits)
  {
    this->ArrowForce = largest;
    this->Scene->SetLargestForce(largest);
  }
}

std::string ComparisonColumn::colorBy(int quantity)
{
  const bool map = quantity >= 0;
  const std::string error = map && !this->MapIsMade ? this->makeMap() : std::string();
  if (!error.empty())
  {
    return error;
  }
  if (map)
  {
    this->Map->SetQuantity(quantity);
  }
  this->Map->SetVisibility(map);
  this->Scene->GetBodyActor()->SetVisibility(!map);
  this->Scene->GetLegend()->SetVisibility(!map);
  return {};
}

std::string ComparisonColumn::makeMap()
{
  if (!this->Body || this->Tools.empty())
  {
    return "there is no body, or no tool";
  }
  const auto given = [this](const char* name)
  { return std::string(this->Body->GetPointData()->HasArray(name) != 0 ? name : ""); };
  const ComparedTool& shown = this->Tools[this->ShownTool];
  vtkNew<vtkPolyData> judged;
  const std::string fault = attachRegime(Ranks(), this->Body,
    { shown.tool, shown.responseName, this->Deflection,
      { this->Material.youngsModulus, this->Material.poissonRatio, 0.0, LayerBase::Bonded, false },
      materialArrays(
        this->Body, { "", given("LayerThickness"), given("GlobalCompliance"), "", "" }) },
    judged);
  this->MapIsMade = fault.empty() && this->Map->SetBody(judged);
  return fault;
}
} // namespace palpate
