// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/PlaceMarker.h"

#include "Interaction/Display/DisplayColors.h"

#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

namespace palpate
{
vtkSmartPointer<vtkActor> makePlaceMarker()
{
  constexpr double radius = 2.0; // mm
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  auto marker = vtkSmartPointer<vtkActor>::New();
  marker->SetMapper(mapper);
  marker->GetProperty()->SetColor(ToolColor[0], ToolColor[1], ToolColor[2]);
  marker->VisibilityOff();
  return marker;
}

void placeMarker(const ShownContact& contact, vtkActor* marker)
{
  const Eigen::Vector3d& place =
    contact.touches() ? contact.tick.contact.contactPoint : contact.tick.tip;
  marker->SetPosition(place.x(), place.y(), place.z());
}
} // namespace palpate
