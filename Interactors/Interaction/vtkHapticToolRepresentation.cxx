// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticToolRepresentation.h"

#include "Interaction/Display/DisplayColors.h"
#include "Interaction/Display/EndOnSign.h"
#include "Interaction/Display/ForceArrow.h"
#include "Interaction/Display/LabelLayout.h"
#include "Interaction/Display/RigidFrame.h"
#include "Interaction/Display/ShownContact.h"
#include "vtkContactTool.h"
#include "vtkContactToolSource.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
constexpr double RimWidth = 0.1;      // fraction of the tool's radius
constexpr double AppliedOffset = 6.0; // mm, distance between the arrows of applied and ideal force

constexpr palpate::ArrowLook TotalLook = { palpate::ForceColor, 0.9, 2.4, 6.0, 22, true, 0.0 };
constexpr palpate::ArrowLook AppliedLook = { palpate::AppliedForceColor, 0.9, 2.4, 6.0, 16, true,
  0.65 };
constexpr palpate::ArrowLook NormalLook = { palpate::NormalForceColor, 0.45, 1.4, 4.0, 16, false,
  0.65 };
constexpr palpate::ArrowLook FrictionLook = { palpate::FrictionForceColor, 0.45, 1.4, 4.0, 16,
  false, 0.65 };

/// Returns the unit vector perpendicular to `arrow` that points to the right in the picture.
Eigen::Vector3d rightOf(const Eigen::Vector3d& arrow, vtkCamera* camera)
{
  const Eigen::Vector3d ahead(camera->GetDirectionOfProjection());
  const Eigen::Vector3d along = arrow.normalized();
  const Eigen::Vector3d right = ahead.cross(along);
  // If the arrow points at the camera, this vector is undefined. Then the right direction of the
  // camera is used instead.
  return right.norm() > 0.1 ? right.normalized()
                            : ahead.cross(Eigen::Vector3d(camera->GetViewUp())).normalized();
}
} // namespace

vtkStandardNewMacro(vtkHapticToolRepresentation);

vtkHapticToolRepresentation::vtkHapticToolRepresentation()
  : Source(vtkSmartPointer<vtkContactToolSource>::New())
  , ToolActor(vtkSmartPointer<vtkActor>::New())
  , Total(std::make_unique<palpate::ForceArrow>(TotalLook))
  , NormalPart(std::make_unique<palpate::ForceArrow>(NormalLook))
  , Friction(std::make_unique<palpate::ForceArrow>(FrictionLook))
  , Applied(std::make_unique<palpate::ForceArrow>(AppliedLook))
  , Torque(std::make_unique<palpate::TorqueArc>())
  , TotalSign(std::make_unique<palpate::EndOnSign>(palpate::ForceColor))
  , AppliedSign(std::make_unique<palpate::EndOnSign>(palpate::AppliedForceColor))
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

  this->AddPart(this->ToolActor);
  for (palpate::ForceArrow* arrow :
    { this->Total.get(), this->NormalPart.get(), this->Friction.get(), this->Applied.get() })
  {
    this->AddPart(arrow->actor());
    this->AddPart(arrow->label());
  }
  this->AddPart(this->Torque->actor());
  this->AddPart(this->Torque->label());
  this->AddPart(this->TotalSign->actor());
  this->AddPart(this->AppliedSign->actor());
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

void vtkHapticToolRepresentation::SetTilt(const double axis[3], const double torque[3])
{
  std::copy_n(axis, 3, this->OwnAxis);
  std::copy_n(torque, 3, this->TorqueAboutTip);
}

void vtkHapticToolRepresentation::SetContact(
  const double tip[3], const double normal[3], const double contactPoint[3], const double force[3])
{
  const double none[3] = { 0.0, 0.0, 0.0 };
  this->SetContact(tip, normal, contactPoint, force, none, force);
}

void vtkHapticToolRepresentation::SetContact(const double tip[3], const double normal[3],
  const double contactPoint[3], const double force[3], const double friction[3],
  const double applied[3])
{
  const double* along = vtkMath::Norm(this->OwnAxis) > 0.0 ? this->OwnAxis : normal;
  if (vtkMath::Norm(along) > 0.0)
  {
    std::copy_n(along, 3, this->Axis);
  }
  this->ToolActor->SetUserMatrix(palpate::frameAlong(tip, this->Axis, 2));
  std::copy_n(contactPoint, 3, this->ContactPoint);

  const Eigen::Vector3d origin(contactPoint);
  const Eigen::Vector3d total(force);
  const Eigen::Vector3d rubbing(friction);
  const Eigen::Vector3d told(applied);
  this->Total->show(origin, total, this->ForceScale, this->BeyondValidity);
  if (this->ComponentsVisibility && palpate::isNoticeable(rubbing, total))
  {
    this->NormalPart->show(
      origin, total - rubbing, this->ForceScale, this->BeyondValidity, "normal");
    this->Friction->show(origin, rubbing, this->ForceScale, this->BeyondValidity, "friction");
  }
  else
  {
    this->NormalPart->hide();
    this->Friction->hide();
  }
  if (this->AppliedForceVisibility && palpate::isNoticeable(told - total, total))
  {
    this->Applied->show(origin, told, this->ForceScale, this->BeyondValidity, "applied");
  }
  else
  {
    this->Applied->hide();
  }
  const Eigen::Vector3d torque(this->TorqueAboutTip);
  if (palpate::isNoticeable(torque / palpate::TorqueArc::Radius, total))
  {
    // The arc begins on the side to which the tool is tilted. On that side the contact pushes the
    // tool up.
    const Eigen::Vector3d side = Eigen::Vector3d(this->Axis).cross(torque);
    this->Torque->show(Eigen::Vector3d(tip), torque, side, this->ForceScale);
  }
  else
  {
    this->Torque->hide();
  }
  this->Modified();
}

int vtkHapticToolRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (renderer && this->Applied->isShown())
  {
    // The arrow of the applied force is drawn to the right of the ideal force. If the ideal force
    // is not shown, the direction of the applied force itself is used.
    const Eigen::Vector3d origin(this->ContactPoint);
    const Eigen::Vector3d arrow =
      (this->Total->isShown() ? this->Total->head() : this->Applied->head()) - origin;
    this->Applied->moveTo(origin + AppliedOffset * rightOf(arrow, renderer->GetActiveCamera()));
  }
  return this->Superclass::RenderOpaqueGeometry(viewport);
}

void vtkHapticToolRepresentation::SetLabelsAfter(vtkHapticToolRepresentation* other)
{
  for (vtkHapticToolRepresentation* before = other; before; before = before->LabelsAfter)
  {
    if (before == this)
    {
      vtkErrorMacro(<< "Labels cannot be placed after themselves.");
      return;
    }
  }
  this->LabelsAfter = other;
  this->Modified();
}

/// Collects the labels in the order in which they are placed.
void vtkHapticToolRepresentation::CollectLabels(std::vector<palpate::AnchoredLabel>& labels)
{
  if (this->LabelsAfter)
  {
    this->LabelsAfter->CollectLabels(labels);
  }
  const auto add = [&labels](palpate::ForceArrow& arrow, const Eigen::Vector3d& tail)
  {
    if (arrow.isShown())
    {
      labels.push_back({ arrow.label(), tail, arrow.head(), arrow.labelPlace() });
    }
  };
  add(*this->Total, this->Total->tail());
  // The label of the applied force is placed to the right of its arrow, because the ideal force is
  // on the left.
  const Eigen::Vector3d right = this->Applied->tail() - Eigen::Vector3d(this->ContactPoint);
  add(*this->Applied, this->Applied->head() - right);
  add(*this->NormalPart, this->NormalPart->tail());
  add(*this->Friction, this->Friction->tail());
  if (this->Torque->isShown())
  {
    labels.push_back({ this->Torque->label(), this->Torque->center(), this->Torque->head(),
      this->Torque->labelPlace() });
  }
}

/// Adds the tool to the obstacles: its axis with the radius of the tool, and the rim at its upper
/// end, which the rounded end of the axis does not cover.
void vtkHapticToolRepresentation::CollectTool(std::vector<palpate::LabelObstacle>& obstacles)
{
  vtkMatrix4x4* frame = this->ToolActor->GetUserMatrix();
  if (!this->GetTool() || !frame)
  {
    return;
  }
  this->Source->Update();
  double bounds[6];
  this->Source->GetOutput()->GetBounds(bounds); // the tip is at the origin, the axis is z
  const double radius = std::max(bounds[1], bounds[3]);
  const auto inWorld = [frame](double x, double y, double z) -> Eigen::Vector3d
  {
    const double local[4] = { x, y, z, 1.0 };
    double world[4];
    frame->MultiplyPoint(local, world);
    return Eigen::Vector3d(world);
  };
  const double end = std::min(radius, 0.5 * (bounds[5] - bounds[4]));
  obstacles.push_back(
    { inWorld(0.0, 0.0, bounds[4] + end), inWorld(0.0, 0.0, bounds[5] - end), radius });
  constexpr int corners = 12;
  const auto rim = [&](int i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / corners;
    return inWorld(radius * std::cos(angle), radius * std::sin(angle), bounds[5]);
  };
  for (int i = 0; i < corners; ++i)
  {
    obstacles.push_back({ rim(i), rim(i + 1), RimWidth * radius });
  }
}

/// Collects all parts that labels must not cover: the tool, the arrows with their signs, and the
/// contact circle.
void vtkHapticToolRepresentation::CollectObstacles(std::vector<palpate::LabelObstacle>& obstacles)
{
  if (this->LabelsAfter)
  {
    this->LabelsAfter->CollectObstacles(obstacles);
  }
  obstacles.insert(obstacles.end(), this->LeftFree.begin(), this->LeftFree.end());
  this->CollectTool(obstacles);
  for (const palpate::ForceArrow* arrow :
    { this->Total.get(), this->NormalPart.get(), this->Friction.get(), this->Applied.get() })
  {
    arrow->addTo(obstacles);
  }
  this->Torque->addTo(obstacles);
  if (this->TotalSign->isShown())
  {
    obstacles.push_back({ this->Total->head(), this->Total->head(), this->TotalSign->radius() });
  }
  if (this->AppliedSign->isShown())
  {
    obstacles.push_back(
      { this->Applied->head(), this->Applied->head(), this->AppliedSign->radius() });
  }
  if (this->ContactRadius > 0.0)
  {
    const Eigen::Vector3d contact(this->ContactPoint);
    obstacles.push_back({ contact, contact, this->ContactRadius });
  }
}

void vtkHapticToolRepresentation::LeaveFree(std::vector<palpate::LabelObstacle> obstacles)
{
  this->LeftFree = std::move(obstacles);
}

int vtkHapticToolRepresentation::RenderOverlay(vtkViewport* viewport)
{
  if (auto* renderer = vtkRenderer::SafeDownCast(viewport))
  {
    for (const auto& [arrow, sign] : { std::pair{ this->Total.get(), this->TotalSign.get() },
           std::pair{ this->Applied.get(), this->AppliedSign.get() } })
    {
      if (arrow->isShown())
      {
        sign->show(renderer, arrow->tail(), arrow->head());
      }
      else
      {
        sign->hide();
      }
    }
    std::vector<palpate::AnchoredLabel> labels;
    std::vector<palpate::LabelObstacle> obstacles;
    this->CollectLabels(labels);
    this->CollectObstacles(obstacles);
    palpate::arrangeLabels(renderer, labels, obstacles, this->SteadyLabels);
  }
  return this->Superclass::RenderOverlay(viewport);
}

void vtkHapticToolRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->GetTool() << "\n";
  os << indent << "ForceScale: " << this->ForceScale << " mm/N\n";
  os << indent << "ComponentsVisibility: " << this->ComponentsVisibility << "\n";
  os << indent << "AppliedForceVisibility: " << this->AppliedForceVisibility << "\n";
  os << indent << "BeyondValidity: " << this->BeyondValidity << "\n";
  os << indent << "ContactRadius: " << this->ContactRadius << " mm\n";
  os << indent << "SteadyLabels: " << this->SteadyLabels << "\n";
}
