// SPDX-License-Identifier: BSD-3-Clause
// A live session in a scene: the applied force next to the ideal force with the reason for the
// difference, the validity of the session's response, the trail of the last contacts, and the
// camera.
#include "PlacedDevice.h"
#include "SceneParts.h"

#include "vtkCamera.h"
#include "vtkContactScene.h"
#include "vtkRenderWindow.h"
#include "vtkScalarBarActor.h"

namespace
{
using namespace palpate::testing;

constexpr double Up[3] = { 0.0, 0.0, 1.0 };

/// The path: one second in the air, one second down to 1.5 mm, four seconds along x, one second up
/// and outside, and one second down again at another place.
Body handPath()
{
  const double times[] = { 0.0, 1.0, 2.0, 6.0, 7.0, 8.0, 9.0 };
  const double x[] = { -6.0, -6.0, -6.0, 6.0, 6.0, 0.3, 0.3 };
  const double y[] = { 0.2, 0.2, 0.2, 0.2, 0.2, 5.0, 5.0 };
  const double z[] = { 2.0, 2.0, -1.5, -1.5, 2.0, 2.0, -1.0 };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(7);
  for (std::size_t i = 0; i < 7; ++i)
  {
    line->InsertCellPoint(points->InsertNextPoint(x[i], y[i], z[i]));
    time->InsertNextValue(times[i]);
  }
  auto path = Body::New();
  path->SetPoints(points);
  path->SetLines(line);
  path->GetPointData()->AddArray(time);
  return path;
}

/// Steps the session and shows it, 25 times a second.
void play(vtkHapticSession* session, vtkContactScene* scene, double seconds)
{
  for (int i = 0; i < std::lround(25.0 * seconds); ++i)
  {
    session->Step(0.04);
    scene->ShowSession(session);
  }
}

double shown(vtkActor* arrow, const double from[3], const double force[3])
{
  double direction[3] = { force[0], force[1], force[2] };
  vtkMath::Normalize(direction);
  return extentAlong(arrow, from, direction).high;
}

vtkPolyData* drawnBy(vtkActor* actor)
{
  actor->GetMapper()->Update();
  return vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
}

/// Checks a contact, 1.5 mm deep, during the slide.
void checkContact(vtkHapticSession* session, vtkContactScene* scene)
{
  const ForceParts parts(scene->GetToolRepresentation());
  double contact[3];
  double ideal[3];
  double applied[3];
  double friction[3];
  session->GetContactPoint(contact);
  session->GetIdealForce(ideal);
  session->GetForce(applied);
  session->GetFrictionForce(friction);
  const double scale = scene->GetToolRepresentation()->GetForceScale();
  PALPATE_CHECK_NEAR(vtkMath::Norm(applied), 5.0, 1e-9); // the limit set in the session
  PALPATE_CHECK_NEAR(shown(parts.total, contact, ideal), scale * vtkMath::Norm(ideal), 1e-4);
  PALPATE_CHECK_NEAR(
    shown(parts.friction, contact, friction), scale * vtkMath::Norm(friction), 1e-4);
  // Nothing has been rendered, so the applied force is not yet drawn beside the ideal force.
  PALPATE_CHECK(parts.applied->GetVisibility());
  PALPATE_CHECK_NEAR(shown(parts.applied, contact, applied), scale * 5.0, 1e-4);
  PALPATE_CHECK_TEXT(caption(scene->GetRenderer()), "Deflection 1.50 mm",
    "\nApplied 5.00 N: limited to the device's largest force", "(strain)");
  PALPATE_CHECK(!scene->IsValid());
}
} // namespace

int TestContactSceneSession(int, char*[])
{
  const Body body = threeTools();
  vtkNew<vtkHapticSession> session;
  session->SetBody(body);
  session->SetResponseName("Sphere");
  session->GetDevice()->SetPath(handPath());
  session->GetSettings()->SetFrictionCoefficient(0.3);
  session->GetSettings()->SetTangentialStiffness(50.0);
  session->GetSafety()->SetForceLimit(5.0);
  PALPATE_CHECK(session->Start());

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(body);
  scene->SetResponseName("Sphere");
  scene->SetTool(makeTool("sphere:6.35"));
  scene->SetLargestForce(25.0);
  scene->SetTrailLength(50); // two seconds

  // In the air the tool has the given direction. Nothing else is shown.
  const double aslant[3] = { 0.6, 0.0, 0.8 };
  session->Step(0.5);
  scene->SetFreeDirection(aslant);
  scene->ShowSession(session);
  const ForceParts parts(scene->GetToolRepresentation());
  double tip[3];
  session->GetTip(tip);
  const Extent tool = extentAlong(ToolParts(scene->GetToolRepresentation()).tool, tip, aslant);
  PALPATE_CHECK_NEAR(tool.high, scene->GetToolRepresentation()->GetToolLength(), 1e-4);
  PALPATE_CHECK(!parts.total->GetVisibility() && !parts.applied->GetVisibility());
  PALPATE_CHECK(!scene->GetTrailActor()->GetVisibility() && scene->IsValid());
  PALPATE_CHECK(!scene->GetCircleActor()->GetVisibility());
  PALPATE_CHECK(caption(renderer) == "Tool: sphere, radius 6.35 mm");

  play(session, scene, 4.5); // 3 s after the start of the slide at 3 mm/s
  checkContact(session, scene);

  // The trail has the last 50 points: two seconds, 6 mm, less one step.
  double bounds[6];
  drawnBy(scene->GetTrailActor())->GetBounds(bounds);
  double contact[3];
  session->GetContactPoint(contact);
  PALPATE_CHECK_NEAR(bounds[1], contact[0], 1.6); // the trail may end with a gap between dashes
  PALPATE_CHECK_NEAR(bounds[0], contact[0] - 49 * 0.12, 1.6);
  PALPATE_CHECK(scene->GetTrailActor()->GetVisibility());
  vtkScalarBarActor* legend = scene->GetTrailLegend();
  PALPATE_CHECK_TEXT(legend->GetTitle(), "Force (N)");
  PALPATE_CHECK(std::string(legend->GetTitle()).find("no contact") == std::string::npos);

  // After the tool has lifted off, the camera still looks at the last contact. The trail remains,
  // and is not drawn through the air to the next contact.
  play(session, scene, 2.5);
  PALPATE_CHECK(session->GetContactCell() < 0);
  scene->LookAtContact(100.0, Up, aslant);
  double* focus = renderer->GetActiveCamera()->GetFocalPoint();
  PALPATE_CHECK_NEAR(focus[0], 6.0 + 9.0 * 0.6, 1e-4); // raised by 9 % of the distance along `up`
  play(session, scene, 1.5);
  PALPATE_CHECK(session->GetContactCell() >= 0);
  vtkPolyData* trail = drawnBy(scene->GetTrailActor());
  for (vtkIdType i = 0; i < trail->GetNumberOfCells(); ++i)
  {
    double piece[6];
    trail->GetCellBounds(i, piece);
    PALPATE_CHECK(piece[3] < 1.0 || piece[2] > 4.0); // the contacts were at y = 0.2 mm and 5 mm
  }
  PALPATE_CHECK_TEXT(legend->GetTitle(), "Force (N)", "gap: no contact");
  scene->ClearTrail();
  PALPATE_CHECK(!scene->GetTrailActor()->GetVisibility());
  PALPATE_CHECK(std::string(legend->GetTitle()).find("gap") == std::string::npos);

  // Another response of the same body, of a flat punch of 1.6 mm, has another validity.
  session->SetResponseName("Flat");
  PALPATE_CHECK(session->ApplyChanges());
  session->Step(0.1);
  scene->ShowSession(session);
  // A/R is not defined for a flat end; it is valid to a depth of 0.4 R
  PALPATE_CHECK_NEAR(scene->GetValidity(), 0.64, 1e-6);

  // A stopped session applies no force, and the caption shows no difference.
  session->Stop();
  scene->ShowSession(session);
  PALPATE_CHECK(!parts.applied->GetVisibility());
  PALPATE_CHECK(caption(renderer).find("Applied") == std::string::npos);
  return palpate::testing::result();
}
