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
constexpr double Closest = 1e-6; // mm: nearer points are merged
}

DashedLine::DashedLine(double dash, double gap)
  : Dash(dash)
  , Gap(gap)
  , Left(dash)
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
  this->Left = this->Dash;
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
    this->Left = this->Dash;
    this->extend(point, value);
    return;
  }
  double along = 0.0;
  while (length - along > this->Left)
  {
    along += this->Left;
    const double share = along / length;
    const Eigen::Vector3d cut = from + share * (point - from);
    const double cutValue = fromValue + share * (value - fromValue);
    if (!this->InGap)
    {
      this->extend(cut, cutValue);
    }
    this->end();
    this->Last = cut;
    this->LastValue = cutValue;
    this->InGap = !this->InGap;
    this->Left = this->InGap ? this->Gap : this->Dash;
  }
  this->Left -= length - along;
  if (!this->InGap)
  {
    this->extend(point, value);
  }
  this->Last = point;
  this->LastValue = value;
}

void DashedLine::extend(const Eigen::Vector3d& point, double value)
{
  if ((point - this->Last).norm() > Closest)
  {
    if (this->Open == 0)
    {
      this->Lines->InsertNextCell(0);
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(this->Last.data()));
      this->Values->InsertNextValue(this->LastValue);
      this->Open = 1;
    }
    this->Lines->InsertCellPoint(this->Points->InsertNextPoint(point.data()));
    this->Values->InsertNextValue(value);
    ++this->Open;
  }
  this->Last = point;
  this->LastValue = value;
}

void DashedLine::end()
{
  if (this->Open > 0)
  {
    this->Lines->UpdateCellCount(static_cast<int>(this->Open));
    this->Open = 0;
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
