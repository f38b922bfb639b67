// SPDX-License-Identifier: BSD-3-Clause
#include "vtkForceChartRepresentation.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkObjectFactory.h"
#include "vtkPVView.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkTable.h"

#include <array>
#include <map>

vtkStandardNewMacro(vtkForceChartRepresentation);

void vtkForceChartRepresentation::SetAbscissa(const char* name)
{
  const std::string next = name && *name ? name : GetFirstColumn();
  if (this->Abscissa != next)
  {
    this->Abscissa = next;
    this->Modified();
  }
}

/// Sets the title of an axis unless the user has set another title.
void vtkForceChartRepresentation::TitleAxis(int axis, const std::string& title, std::string& given)
{
  vtkAxis* shown = this->GetChart()->GetAxis(axis);
  const std::string present = shown->GetTitle();
  if (present.empty() || present == given)
  {
    shown->SetTitle(title);
    given = title;
  }
}

void vtkForceChartRepresentation::PrepareForRendering()
{
  vtkTable* table = this->GetLocalOutput();
  if (!table || table->GetNumberOfColumns() == 0 || !this->GetVisibility())
  {
    this->Superclass::PrepareForRendering();
    return;
  }
  const bool first = this->Abscissa == GetFirstColumn() ||
    !table->GetColumnByName(this->Abscissa.c_str()); // the column existed before the filter changed
  const std::string abscissa = first ? table->GetColumnName(0) : this->Abscissa;
  this->SetXAxisSeriesName(abscissa.c_str());
  this->Superclass::PrepareForRendering();
  if (table->GetNumberOfRows() < 2) // a line needs two points, and a history begins with one point
  {
    vtkChartXY* chart = this->GetChart();
    for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
    {
      if (chart->GetPlot(i)->GetInput() == table)
      {
        chart->GetPlot(i)->SetVisible(false);
      }
    }
  }
}

/// Styles the error bounds of a force (vtkResponseCurves.h) as thin lines in the colour of the
/// force, without an entry in the legend.
void vtkForceChartRepresentation::StyleBands()
{
  vtkChartXY* chart = this->GetChart();
  std::map<std::string, vtkPlot*> plots;
  for (vtkIdType i = 0; i < chart->GetNumberOfPlots(); ++i)
  {
    plots[chart->GetPlot(i)->GetLabel()] = chart->GetPlot(i);
  }
  for (const auto& [name, plot] : plots)
  {
    for (const std::string end : { ", least (N)", ", most (N)" })
    {
      if (name.size() <= end.size() || name.compare(name.size() - end.size(), end.size(), end) != 0)
      {
        continue;
      }
      const auto force = plots.find(name.substr(0, name.size() - end.size()) + " (N)");
      if (force != plots.end())
      {
        std::array<double, 3> color{};
        force->second->GetPen()->GetColorF(color.data());
        plot->GetPen()->SetColorF(color[0], color[1], color[2]);
      }
      plot->SetWidth(1.0F);
      plot->SetLegendVisibility(false);
    }
  }
}

/// Sets the titles again before each rendering, because the view may have cleared them.
int vtkForceChartRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output)
{
  const int done = this->Superclass::ProcessViewRequest(request, input, output);
  if (done && request == vtkPVView::REQUEST_RENDER() && this->GetVisibility() && this->GetChart())
  {
    if (!this->GetUseIndexForXAxis() && this->GetXAxisSeriesName())
    {
      this->TitleAxis(vtkAxis::BOTTOM, this->GetXAxisSeriesName(), this->BottomTitle);
    }
    this->TitleAxis(vtkAxis::LEFT, "Force (N)", this->LeftTitle);
    this->StyleBands();
  }
  return done;
}
