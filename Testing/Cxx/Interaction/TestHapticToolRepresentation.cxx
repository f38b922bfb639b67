// SPDX-License-Identifier: BSD-3-Clause
// The tool is drawn with its tip at the given point, along the normal. The arrow has the length of
// the force, or is absent.
#include "Picture.h"
#include "Response/TestBodies.h"
#include "SceneParts.h"

#include "vtkCamera.h"

namespace
{
using namespace palpate::testing;

constexpr double Rounding = 1e-5; // mm: the geometry of the tool and the arrow is in floats
constexpr double Tip[3] = { 1.0, -2.0, 3.0 };
constexpr double Contact[3] = { 1.5, -1.0, 4.0 };
constexpr double Normal[3] = { 0.6, 0.0, 0.8 };

void checkTool(const ToolParts& parts, const double tip[3], const double normal[3], double length)
{
  const Extent tool = extentAlong(parts.tool, tip, normal);
  PALPATE_CHECK_NEAR(tool.low, 0.0, Rounding);
  PALPATE_CHECK_NEAR(tool.high, length, Rounding);
  // The radius of the shaft, because the tool is upright.
  PALPATE_CHECK_NEAR(tool.aside, 4.0, Rounding);
}

void checkArrow(const ToolParts& parts, const double force[3], double scale)
{
  double direction[3] = { force[0], force[1], force[2] };
  const double magnitude = vtkMath::Normalize(direction);
  PALPATE_CHECK(parts.arrow->GetVisibility() && parts.label->GetVisibility());
  const Extent arrow = extentAlong(parts.arrow, Contact, direction);
  PALPATE_CHECK_NEAR(arrow.low, 0.0, Rounding);
  PALPATE_CHECK_NEAR(arrow.high, scale * magnitude, Rounding);
  PALPATE_CHECK_NEAR(arrow.aside, 2.4, Rounding); // radius of the head, the same for every force
  double* head = parts.label->GetPositionCoordinate()->GetValue();
  for (int k = 0; k < 3; ++k)
  {
    PALPATE_CHECK_NEAR(head[k], Contact[k] + scale * force[k], 1e-12);
  }
}

void checkNumbers(vtkHapticToolRepresentation* representation)
{
  const ToolParts parts(representation);
  const double none[3] = { 0.0, 0.0, 0.0 };
  const double notANumber[3] = { std::nan(""), 0.0, 0.0 };
  const double slanted[3] = { 0.3, 1.2, 0.4 }; // magnitude 1.3 N
  PALPATE_CHECK_NEAR(representation->GetForceScale(), 10.0, 0.0);
  PALPATE_CHECK_NEAR(representation->GetToolLength(), 22.0, 0.0);
  PALPATE_CHECK(!parts.arrow->GetVisibility() && !parts.label->GetVisibility());

  representation->SetContact(Tip, Normal, Contact, slanted);
  checkTool(parts, Tip, Normal, 22.0);
  checkArrow(parts, slanted, 10.0);
  PALPATE_CHECK(std::string(parts.label->GetInput()) == "1.30 N");

  // Ten times the scale and a tenth of the force give the same length. The label shows the force.
  const double tenth[3] = { 0.03, 0.12, 0.04 };
  representation->SetForceScale(100.0);
  representation->SetToolLength(30.0);
  representation->SetContact(Tip, Normal, Contact, tenth);
  checkArrow(parts, tenth, 100.0);
  checkTool(parts, Tip, Normal, 30.0);
  PALPATE_CHECK(std::string(parts.label->GetInput()) == "0.130 N");
  representation->SetForceScale(10.0);
  representation->SetToolLength(22.0);

  // Without a force there is no arrow. Without a normal the last direction is used.
  for (const double* force : { none, notANumber })
  {
    representation->SetContact(Tip, none, Contact, force);
    PALPATE_CHECK(!parts.arrow->GetVisibility() && !parts.label->GetVisibility());
    checkTool(parts, Tip, Normal, 22.0);
  }

  // Along each axis, because a frame could degenerate there.
  for (int axis = 0; axis < 3; ++axis)
  {
    double along[3] = { 0.0, 0.0, 0.0 };
    along[axis] = axis == 1 ? -1.0 : 1.0;
    representation->SetContact(Tip, along, Contact, along);
    checkTool(parts, Tip, along, 22.0);
    checkArrow(parts, along, 10.0);
  }
}

void look(vtkRenderer* renderer)
{
  renderer->SetBackground(0.97, 0.97, 0.98);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(8.0, 0.0, 14.0);
  camera->SetPosition(8.0, -90.0, 20.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}
} // namespace

int TestHapticToolRepresentation(int argc, char* argv[])
{
  vtkNew<vtkHapticToolRepresentation> representation;
  representation->SetTool(makeTool("sphere:4"));
  checkNumbers(representation);

  Picture picture(480, 360);
  auto renderer = picture.addRenderer();
  renderer->AddViewProp(representation);
  const double force[3] = { 1.2, -0.5, 1.6 };
  representation->SetContact(Tip, Normal, Contact, force);
  look(renderer);
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  const double none[3] = { 0.0, 0.0, 0.0 };
  representation->SetContact(Tip, Normal, Contact, none);
  checkFaultShows("no arrow", sound, picture.window);
  const double upward[3] = { 0.0, 0.0, vtkMath::Norm(force) };
  representation->SetContact(Tip, Normal, Contact, upward);
  checkFaultShows("arrow in another direction", sound, picture.window);
  representation->SetContact(Tip, upward, Contact, force);
  checkFaultShows("tool not along the normal", sound, picture.window);
  representation->SetForceScale(9.0);
  representation->SetContact(Tip, Normal, Contact, force);
  checkFaultShows("arrow a tenth too short", sound, picture.window);
  representation->SetForceScale(10.0);
  representation->SetContact(Tip, Normal, Contact, force);
  representation->SetTool(makeTool("flat:4"));
  checkFaultShows("another tool of the same radius", sound, picture.window);
  representation->SetTool(makeTool("sphere:4"));
  checkSound(sound, picture.window);
  return palpate::testing::result();
}
