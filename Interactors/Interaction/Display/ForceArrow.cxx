// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ForceArrow.h"

#include "Interaction/Display/DashedLine.h"
#include "Interaction/Display/RigidFrame.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkArcSource.h"
#include "vtkConeSource.h"
#include "vtkCoordinate.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTubeFilter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr double Dash = 3.2;        // length of a dash, mm
constexpr double Gap = 1.8;         // length of a gap, mm
constexpr double LargestHead = 0.4; // largest length of the head, as a fraction of the arrow
constexpr int Sides = 32;

constexpr double ArcTubeRadius = 0.55; // mm
constexpr double ArcHeadRadius = 1.6;  // mm
constexpr double ArcHeadLength = 3.6;  // mm
constexpr double ArcMostTurn = 5.2;    // largest angle of the arc, rad
constexpr double ArcStart = 0.15;      // rad, gap between the start of the arc and the surface
constexpr double ArcLeastTurn = 0.15;  // rad; for a smaller angle only the head is drawn
constexpr int ArcSides = 24;
constexpr int ArcPieces = 48;
constexpr int ArcLabelSize = 18; // points
} // namespace

ForceArrow::ForceArrow(const ArrowLook& look)
  : Look(look)
  , Shaft(vtkSmartPointer<vtkTubeFilter>::New())
  , Cone(vtkSmartPointer<vtkConeSource>::New())
  , Actor(vtkSmartPointer<vtkActor>::New())
  , Label(vtkSmartPointer<vtkTextActor>::New())
{
  this->Shaft->SetNumberOfSides(Sides);
  this->Shaft->CappingOn();
  this->Cone->SetResolution(Sides);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(this->Shaft->GetOutputPort());
  both->AddInputConnection(this->Cone->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(both->GetOutputPort());
  mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetColor(look.color[0], look.color[1], look.color[2]);
  this->Actor->GetProperty()->SetAmbient(0.3);

  vtkTextProperty* text = this->Label->GetTextProperty();
  text->SetColor(this->Look.color.data());
  text->SetFontSize(look.labelSize);
  text->SetBold(look.bold ? 1 : 0);
  // The background makes the text readable in front of the tool and other arrows.
  text->SetBackgroundColor(BackgroundColor.data());
  text->SetBackgroundOpacity(look.labelOpacity);
  this->Label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  this->hide();
}

ForceArrow::~ForceArrow() = default;

void ForceArrow::show(const Eigen::Vector3d& origin, const Eigen::Vector3d& force, double scale,
  bool dashed, const std::string& name)
{
  const double magnitude = force.norm();
  const double length = magnitude * scale;
  if (!std::isfinite(length) || !(length > 0.0))
  {
    this->hide();
    return;
  }
  const double size = std::min(1.0, length / this->Look.headLength);
  const double neck = length - std::min(this->Look.headLength, LargestHead * length);
  DashedLine shaft(size * Dash, size * Gap);
  shaft.moveTo(Eigen::Vector3d::Zero());
  shaft.lineTo(Eigen::Vector3d(neck, 0.0, 0.0), 0.0, dashed);
  this->Shaft->SetInputData(shaft.take("Force"));
  this->Shaft->SetRadius(size * this->Look.shaftRadius);
  this->Cone->SetHeight(length - neck);
  this->Cone->SetRadius(size * this->Look.headRadius);
  this->Cone->SetCenter(0.5 * (length + neck), 0.0, 0.0);
  this->ArrowVector = scale * force;
  this->moveTo(origin);
  this->Actor->VisibilityOn();
  this->Label->VisibilityOn();
  std::array<char, 64> text{};
  std::snprintf(
    text.data(), text.size(), "%s%s%#.3g N", name.c_str(), name.empty() ? "" : " ", magnitude);
  this->Label->SetInput(text.data());
}

void ForceArrow::hide()
{
  this->Place = {};
  this->Actor->VisibilityOff();
  this->Label->VisibilityOff();
}

bool ForceArrow::isShown() const
{
  return this->Actor->GetVisibility() != 0;
}

void ForceArrow::moveTo(const Eigen::Vector3d& origin)
{
  this->Head = origin + this->ArrowVector;
  this->Actor->SetUserMatrix(frameAlong(origin.data(), this->ArrowVector.data(), 0));
  this->Label->GetPositionCoordinate()->SetValue(this->Head.data());
}

void ForceArrow::addTo(std::vector<LabelObstacle>& obstacles) const
{
  if (!this->isShown())
  {
    return;
  }
  obstacles.push_back({ this->tail(), this->Head, this->Shaft->GetRadius() });
  // Only the wide part of the cone, near its base, is an obstacle.
  const Eigen::Vector3d cone = this->Cone->GetHeight() * this->ArrowVector.normalized();
  obstacles.push_back({ this->Head - cone, this->Head - 0.6 * cone, this->Cone->GetRadius() });
}

TorqueArc::TorqueArc()
  : Arc(vtkSmartPointer<vtkArcSource>::New())
  , Cone(vtkSmartPointer<vtkConeSource>::New())
  , Actor(vtkSmartPointer<vtkActor>::New())
  , Label(vtkSmartPointer<vtkTextActor>::New())
{
  this->Arc->UseNormalAndAngleOn();
  this->Arc->SetResolution(ArcPieces);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(this->Arc->GetOutputPort());
  tube->SetRadius(ArcTubeRadius);
  tube->SetNumberOfSides(ArcSides);
  tube->CappingOn();
  this->Cone->SetResolution(ArcSides);
  this->Cone->SetRadius(ArcHeadRadius);
  this->Cone->SetHeight(ArcHeadLength);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(tube->GetOutputPort());
  both->AddInputConnection(this->Cone->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(both->GetOutputPort());
  mapper->ScalarVisibilityOff();
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetColor(TorqueColor[0], TorqueColor[1], TorqueColor[2]);
  this->Actor->GetProperty()->SetAmbient(0.3);

  vtkTextProperty* text = this->Label->GetTextProperty();
  text->SetColor(TorqueColor.data());
  text->SetFontSize(ArcLabelSize);
  text->SetBold(1);
  text->SetBackgroundColor(BackgroundColor.data());
  text->SetBackgroundOpacity(0.65);
  this->Label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  this->hide();
}

TorqueArc::~TorqueArc() = default;

void TorqueArc::show(const Eigen::Vector3d& center, const Eigen::Vector3d& torque,
  const Eigen::Vector3d& from, double scale)
{
  const double magnitude = torque.norm();
  const double turn = std::min(magnitude * scale / (Radius * Radius), ArcMostTurn);
  if (!std::isfinite(turn) || !(turn > 0.0))
  {
    this->hide();
    return;
  }
  const Eigen::Vector3d normal = torque / magnitude;
  Eigen::Vector3d first = from - normal.dot(from) * normal;
  first = first.norm() > 1e-6 * from.norm() ? first.normalized() : normal.unitOrthogonal();
  const double shown = std::max(turn, ArcLeastTurn);
  const Eigen::Vector3d begin = Eigen::AngleAxisd(ArcStart, normal) * first;
  const Eigen::Vector3d end = Eigen::AngleAxisd(ArcStart + shown, normal) * first;
  const Eigen::Vector3d ahead = normal.cross(end);
  this->Arc->SetCenter(center.x(), center.y(), center.z());
  this->Arc->SetNormal(normal.x(), normal.y(), normal.z());
  this->Arc->SetPolarVector(Radius * begin.x(), Radius * begin.y(), Radius * begin.z());
  this->Arc->SetAngle(vtkMath::DegreesFromRadians(shown));
  this->Center = center;
  this->Head = center + Radius * end + ArcHeadLength * ahead;
  const Eigen::Vector3d middle = center + Radius * end + 0.5 * ArcHeadLength * ahead;
  this->Cone->SetCenter(middle.x(), middle.y(), middle.z());
  this->Cone->SetDirection(ahead.x(), ahead.y(), ahead.z());
  this->Actor->VisibilityOn();
  this->Label->VisibilityOn();
  this->Label->GetPositionCoordinate()->SetValue(this->Head.data());
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%#.3g N mm", magnitude);
  this->Label->SetInput(text.data());
}

void TorqueArc::hide()
{
  this->Place = {};
  this->Actor->VisibilityOff();
  this->Label->VisibilityOff();
}

void TorqueArc::addTo(std::vector<LabelObstacle>& obstacles) const
{
  if (!this->isShown())
  {
    return;
  }
  this->Arc->Update();
  vtkPolyData* arc = this->Arc->GetOutput();
  constexpr vtkIdType step = ArcPieces / 8;
  for (vtkIdType i = step; i < arc->GetNumberOfPoints(); i += step)
  {
    obstacles.push_back({ Eigen::Vector3d(arc->GetPoint(i - step)),
      Eigen::Vector3d(arc->GetPoint(i)), ArcTubeRadius });
  }
  const Eigen::Vector3d middle(this->Cone->GetCenter());
  obstacles.push_back({ middle, middle, ArcHeadRadius });
}

bool TorqueArc::isShown() const
{
  return this->Actor->GetVisibility() != 0;
}
} // namespace palpate
