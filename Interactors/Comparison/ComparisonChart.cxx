// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/ComparisonChart.h"

#include "Contact/ResponseContract.h"
#include "Interaction/Display/DisplayColors.h"
#include "Contact/ResponseField.h"
#include "Response/BodyConversion.h"
#include "Response/Curves/StoredError.h"
#include "Comparison/PointCopy.h"
#include "vtkContactTool.h"
#include "vtkResponseChart.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr int CurveRows = 101;
constexpr float MarkSize = 13.0F;
constexpr float DepthWidth = 1.5F;
constexpr Color DepthColor = { 0.45, 0.45, 0.48 };

/// Makes a table of deflection and force. Two further columns are the bounds of the force.
template <std::size_t Columns>
vtkSmartPointer<vtkTable> makeTable(const std::vector<std::array<double, Columns>>& rows)
{
  constexpr std::array<const char*, 4> names = { "Deflection (mm)", "Force (N)", "Least (N)",
    "Most (N)" };
  auto table = vtkSmartPointer<vtkTable>::New();
  for (std::size_t column = 0; column < Columns; ++column)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(names[column]);
    for (const auto& row : rows)
    {
      values->InsertNextValue(row[column]);
    }
    table->AddColumn(values);
  }
  return table;
}
} // namespace

ComparisonChart::ComparisonChart()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Chart(vtkSmartPointer<vtkResponseChart>::New())
  , Point(makeTable<2>({ { 0.0, 0.0 } }))
{
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  this->Renderer->InteractiveOff();
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(this->Chart->GetChart());
  actor->GetScene()->SetRenderer(this->Renderer);
  this->Renderer->AddActor(actor);
}

ComparisonChart::~ComparisonChart() = default;

vtkResponseChart* ComparisonChart::chart()
{
  return this->Chart;
}

void ComparisonChart::addTo(vtkRenderWindow* window, const double (&viewport)[4])
{
  this->Renderer->SetViewport(viewport);
  window->AddRenderer(this->Renderer);
}

std::string ComparisonChart::drawCurves(
  vtkPolyData* body, vtkIdType point, const std::vector<ComparedTool>& tools, double deflection)
{
  const vtkSmartPointer<vtkPolyData> one = copyPoint(body, point);
  this->Chart->RemoveAllCurves();
  this->PointPlot = nullptr;
  for (const ComparedTool& compared : tools)
  {
    std::string fault;
    const auto response = makeResponseField(one, compared.responseName, fault);
    if (!response)
    {
      return "Wrong body: " + fault;
    }
    if (!response->isValid(0))
    {
      return "point " + std::to_string(point) + " has no response '" + compared.responseName + "'";
    }
    const StoredError errors(one, compared.responseName);
    std::vector<std::array<double, 4>> curve;
    for (int row = 0; row < CurveRows; ++row)
    {
      const double depth = response->range(0) * row / (CurveRows - 1);
      const double force = response->evaluate(0, depth).force;
      const double error = std::min(errors.at(0, depth), 1.0);
      curve.push_back({ depth, force, (1.0 - error) * force, (1.0 + error) * force });
    }
    vtkDataArray* validity = one->GetPointData()->GetArray(
      palpate::arrayName(compared.responseName, palpate::ResponseArray::Validity).c_str());
    this->Chart->AddCurve(
      makeTable(curve), compared.tool->GetDescription(), validity->GetTuple1(0));
  }
  this->drawDepth(deflection);
  this->drawPoint();
  return {};
}

void ComparisonChart::drawDepth(double deflection)
{
  const double top = this->Chart->GetChart()->GetAxis(vtkAxis::LEFT)->GetMaximum();
  vtkPlot* line = this->Chart->GetChart()->AddPlot(vtkChart::LINE);
  line->SetInputData(makeTable<2>({ { deflection, 0.0 }, { deflection, top } }), 0, 1);
  line->GetPen()->SetColorF(DepthColor[0], DepthColor[1], DepthColor[2]);
  line->GetPen()->SetLineType(vtkPen::DASH_LINE);
  line->SetWidth(DepthWidth);
  std::array<char, 64> label{};
  std::snprintf(label.data(), label.size(), "depth of the verdict, %.2f mm", deflection);
  line->SetLabel(label.data());
}

void ComparisonChart::drawPoint()
{
  this->PointPlot = this->Chart->GetChart()->AddPlot(vtkChart::POINTS);
  auto* points = vtkPlotPoints::SafeDownCast(this->PointPlot);
  points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
  points->SetMarkerSize(MarkSize);
  points->GetPen()->SetColorF(ForceColor[0], ForceColor[1], ForceColor[2]);
  this->PointPlot->SetInputData(this->Point, 0, 1);
  this->PointPlot->SetLegendVisibility(false);
  this->PointPlot->SetVisible(this->Point->GetValue(0, 0).ToDouble() > 0.0);
}

void ComparisonChart::mark(double deflection, double force)
{
  this->Point->SetValue(0, 0, deflection);
  this->Point->SetValue(0, 1, force);
  this->Point->Modified();
  if (this->PointPlot)
  {
    this->PointPlot->SetVisible(deflection > 0.0);
  }
}
} // namespace palpate
