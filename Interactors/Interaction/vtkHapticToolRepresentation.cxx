// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticToolRepresentation.h"

#include "DisplayColors.h"
#include "vtkContactTool.h"
#include "vtkContactToolSource.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkCoordinate.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double ArrowShaftRadius = 0.9; // mm
constexpr double ArrowHeadRadius = 2.4;  // mm
constexpr double ArrowHeadLength = 6.0;  // mm, at most 40 % of the arrow
constexpr int LabelSize = 22;

/// Rigid frame at `origin` whose column `axis` (0 = x, 2 = z) is `direction`.
vtkSmartPointer<vtkMatrix4x4> frameAlong(
  const double origin[3], const double direction[3], int axis)
{
  double along[3] = { direction[0], direction[1], direction[2] };
  vtkMath::Normalize(along);
  double side[3];
  double other[3];
  vtkMath::Perpendiculars(along, side, other, 0.0);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row)
  {
    matrix->SetElement(row, axis, along[row]);
    matrix->SetElement(row, (axis + 1) % 3, side[row]);
    matrix->SetElement(row, (axis + 2) % 3, other[row]);
    matrix->SetElement(row, 3, origin[row]);
  }
  return matrix;
}
} // namespace

vtkStandardNewMacro(vtkHapticToolRepresentation);

vtkHapticToolRepresentation::vtkHapticToolRepresentation()
  : Source(vtkSmartPointer<vtkContactToolSource>::New())
  , ToolActor(vtkSmartPointer<vtkActor>::New())
  , Arrow(vtkSmartPointer<vtkArrowSource>::New())
  , ArrowActor(vtkSmartPointer<vtkActor>::New())
  , Label(vtkSmartPointer<vtkTextActor>::New())
{
  this->Source->SetLength(22.0);
  vtkNew<vtkPolyDataMapper> toolMapper;
  toolMapper->SetInputConnection(this->Source->GetOutputPort());
  this->ToolActor->SetMapper(toolMapper);
  vtkProperty* tool = this->ToolActor->GetProperty();
  tool->SetColor(palpate::ToolColor[0], palpate::ToolColor[1], palpate::ToolColor[2]);
  tool->SetOpacity(0.45);
  tool->SetSpecular(0.4);
  tool->SetSpecularPower(30.0);
  tool->BackfaceCullingOn();

  this->Arrow->SetTipResolution(32);
  this->Arrow->SetShaftResolution(32);
  vtkNew<vtkPolyDataMapper> arrowMapper;
  arrowMapper->SetInputConnection(this->Arrow->GetOutputPort());
  this->ArrowActor->SetMapper(arrowMapper);
  this->ArrowActor->GetProperty()->SetColor(
    palpate::ForceColor[0], palpate::ForceColor[1], palpate::ForceColor[2]);
  this->ArrowActor->GetProperty()->SetAmbient(0.3);
  this->ArrowActor->VisibilityOff();

  vtkTextProperty* text = this->Label->GetTextProperty();
  text->SetColor(palpate::ForceColor.data());
  text->SetFontSize(LabelSize);
  text->SetBold(1);
  this->Label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  this->Label->VisibilityOff();

  this->AddPart(this->ToolActor);
  this->AddPart(this->ArrowActor);
  this->AddPart(this->Label);
}

vtkHapticToolRepresentation::~vtkHapticToolRepresentation() = default;

void vtkHapticToolRepresentation::SetTool(vtkContactTool* tool)
{
  this->Source->SetTool(tool);
  this->Modified();
}

vtkContactTool* vtkHapticToolRepresentation::GetTool()
{
  return this->Source->GetTool();
}

void vtkHapticToolRepresentation::SetToolLength(double length)
{
  this->Source->SetLength(length);
  this->Modified();
}

double vtkHapticToolRepresentation::GetToolLength()
{
  return this->Source->GetLength();
}

void vtkHapticToolRepresentation::SetContact(
  const double tip[3], const double normal[3], const double contactPoint[3], const double force[3])
{
  if (vtkMath::Norm(normal) > 0.0)
  {
    std::copy_n(normal, 3, this->Axis);
  }
  this->ToolActor->SetUserMatrix(frameAlong(tip, this->Axis, 2));
  const double magnitude = vtkMath::Norm(force);
  const double length = magnitude * this->ForceScale;
  const bool visible = std::isfinite(length) && length > 0.0;
  this->ArrowActor->SetVisibility(visible);
  this->Label->SetVisibility(visible);
  if (visible)
  {
    // vtkArrowSource has unit length along x; the frame is stretched to the length in mm.
    auto frame = frameAlong(contactPoint, force, 0);
    this->Arrow->SetShaftRadius(ArrowShaftRadius / length);
    this->Arrow->SetTipRadius(ArrowHeadRadius / length);
    this->Arrow->SetTipLength(std::min(ArrowHeadLength / length, 0.4));
    std::array<double, 3> head{};
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        frame->SetElement(row, column, length * frame->GetElement(row, column));
      }
      head[static_cast<std::size_t>(row)] = contactPoint[row] + frame->GetElement(row, 0);
    }
    this->ArrowActor->SetUserMatrix(frame);
    this->Label->GetPositionCoordinate()->SetValue(head.data());
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "  %#.3g N", magnitude);
    this->Label->SetInput(text.data());
  }
  this->Modified();
}

void vtkHapticToolRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->GetTool() << "\n";
  os << indent << "ForceScale: " << this->ForceScale << " mm/N\n";
}
