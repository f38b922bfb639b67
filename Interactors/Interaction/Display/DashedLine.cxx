// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/DashedLine.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace palpate
{
namespace
{
constexpr double Closest = 1e-6; // mm; points at a smaller distance are merged
}

DashedLine::DashedLine(double dash, double gap)
  : Dash(dash)
  , Gap(gap)
  , Remaining(dash)
  , Points(vtkSmartPointer<vtkPoints>::New())
  , Lines(vtkSmartPointer<vtkCellArray>::New())
  , Values(vtkSmartPointer<vtkDoubleArray>::New())
{
  this->Points->SetDataTypeToDouble();
}

DashedLine::~DashedLine() = default;

void DashedLine::moveTo(const Eigen::Vector3d& point, double value)
{
  this->end();
  this->Last = point;
  this->LastValue = value;
  this->InGap = false;
  this->IsAfterGap = false;
  this->Remaining = this->Dash;
}

void DashedLine::lineTo(const Eigen::Vector3d& point, double value, bool dashed)
{
  const Eigen::Vector3d from = this->Last;
  const double fromValue = this->LastValue;
  const double length = (point - from).norm();
  if (!(length > Closest))
  {
    return;
  }
  if (!dashed)
  {
    this->InGap = false;
    this->Remaining = this->Dash;
    this->extend(point, value);
    return;
  }
  double along = 0.0;
  while (length - along > this->Remaining)
  {
    along += this->Remaining;
    const double share = along / length;
    const Eigen::Vector3d cut = from + share * (point - from);
    const double cutValue = fromValue + share * (value - fromValue);
    if (!this->InGap)
    {
      this->extend(cut, cutValue);
    }
    this->IsAfterGap = this->InGap;
    this->end();
    this->Last = cut;
    this->LastValue = cutValue;
    this->InGap = !this->InGap;
    this->Remaining = this->InGap ? this->Gap : this->Dash;
  }
  this->Remaining -= length - along;
  if (!this->InGap)
  {
    this->extend(point, value);
  }
  this->IsAfterGap = this->IsAfterGap || this->InGap;
  this->Last = point;
  this->LastValue = value;
}

void DashedLine::extend(const Eigen::Vector3d& point, double value)
{
  if ((point - this->Last).norm() > Closest)
  {
    this->HasGaps = this->HasGaps || this->IsAfterGap;
    this->IsAfterGap = false;
    if (this->OpenPoints == 0)
    {
      this->Lines->InsertNextCell(0);
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(this->Last.data()));
      this->Values->InsertNextValue(this->LastValue);
      this->OpenPoints = 1;
    }
    this->Lines->InsertCellPoint(this->Points->InsertNextPoint(point.data()));
    this->Values->InsertNextValue(value);
    ++this->OpenPoints;
  }
  this->Last = point;
  this->LastValue = value;
}

void DashedLine::end()
{
  if (this->OpenPoints > 0)
  {
    this->Lines->UpdateCellCount(static_cast<int>(this->OpenPoints));
    this->OpenPoints = 0;
  }
}

vtkSmartPointer<vtkPolyData> DashedLine::take(const char* name)
{
  this->end();
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->SetPoints(this->Points);
  lines->SetLines(this->Lines);
  this->Values->SetName(name);
  lines->GetPointData()->SetScalars(this->Values);
  return lines;
}
} // namespace palpate
