// SPDX-License-Identifier: BSD-3-Clause
// Two fingers pinch a strip that is held at one end. Because the strip bends, each finger changes
// the force on the other. Both tools, arrows, dents and circles are drawn, and the caption has a
// line for each hand.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkContactScene.h"
#include "vtkCubeSource.h"
#include "vtkElasticCompliance.h"
#include "vtkHapticSession.h"
#include "vtkToolContactResponse.h"
#include "vtkTriangleFilter.h"
#include "vtkVoxelBody.h"

namespace
{
using namespace palpate::testing;

constexpr double View[3] = { 0.3, -1.0, 0.25 };
constexpr double Up[3] = { 0.0, 0.0, 1.0 };
constexpr double Half = 3.0; // half of the strip's thickness, mm
constexpr double Depth = 0.5;

/// A strip 24 mm long and 12 mm wide, held at its left end. A single finger bends it by
/// millimetres.
Body strip(bool isCoupled)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-12.0, 12.0, -6.0, 6.0, -Half, Half);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(box->GetOutputPort());
  vtkNew<vtkVoxelBody> solid;
  solid->SetInputConnection(triangles->GetOutputPort());
  solid->SetSpacing(1.5);
  solid->SetFixedFaces("x-");
  vtkNew<vtkElasticCompliance> bending;
  bending->SetInputConnection(solid->GetOutputPort());
  bending->SetYoungsModulus(1.0);
  bending->SetPoissonRatio(0.45);
  bending->SetNumberOfCouplingModes(8);
  vtkNew<vtkToolContactResponse> response;
  response->SetInputConnection(bending->GetOutputPort());
  response->SetTool(makeTool("sphere:3"));
  makePlain(response);
  response->SetYoungsModulus(1.0);
  response->SetPoissonRatio(0.45);
  response->SetMaximumDeflection(8.0);
  response->SetNumberOfSamples(32);
  response->SetInputArrayToProcess(
    2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "GlobalCompliance");
  response->SetCoupling(isCoupled);
  response->Update();
  return response->GetOutput();
}

Body pathTo(double x, double from, double to)
{
  Body path = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, 0.2, from);
  points->InsertNextPoint(x, 0.2, to);
  points->InsertNextPoint(x, 0.2, to);
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  for (const double time : { 0.0, 0.2, 1.0 })
  {
    times->InsertNextValue(time);
  }
  path->SetPoints(points);
  path->GetPointData()->AddArray(times);
  return path;
}

/// Presses with one finger from above and with one from below, until both have pressed.
vtkSmartPointer<vtkHapticSession> pinch(vtkPolyData* body, double below)
{
  auto session = vtkSmartPointer<vtkHapticSession>::New();
  session->SetBody(body);
  session->GetDevice()->SetPath(pathTo(0.0, Half + 1.0, Half - Depth));
  PALPATE_CHECK(session->AddDevice("simulated") == 1);
  session->GetDevice(1)->SetPath(pathTo(below, -Half - 1.0, Depth - Half));
  PALPATE_CHECK(session->Start());
  session->Step(0.4);
  return session;
}

double forceOf(vtkHapticSession* session, int hand)
{
  double force[3];
  session->GetIdealForce(hand, force);
  return force[2];
}
} // namespace

int TestContactSceneHands(int argc, char* argv[])
{
  const Body coupled = strip(true);
  const Body alone = strip(false);
  const auto grip = pinch(coupled, 0.0);
  const auto apart = pinch(alone, 0.0);
  // A single finger bends the strip away. A second finger on the other side holds the strip in
  // place.
  PALPATE_CHECK(forceOf(grip, 0) > 3.0 * forceOf(apart, 0));
  PALPATE_CHECK_NEAR(forceOf(grip, 1), -forceOf(grip, 0), 0.05 * forceOf(grip, 0));

  Picture picture(900, 700);
  auto renderer = picture.addRenderer();
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(coupled);
  scene->SetTool(makeTool("sphere:3"));
  scene->SetPoissonRatio(0.45);
  scene->SetLargestForce(4.0 * forceOf(grip, 0));
  scene->SetTrailLength(0);
  scene->SetLargestDeflection(Depth);
  scene->SetTitle("A grip");
  scene->GetToolRepresentation()->SetToolLength(7.0);
  scene->ShowSession(grip);
  scene->LookAtBody(View, Up);
  PALPATE_CHECK_TEXT(
    caption(renderer), "Hand 2: deflection ", " mm (tip 0.50 mm deep), force ", " N");
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  scene->SetBody(alone);
  scene->ShowSession(apart);
  checkFaultShows("fingers that do not feel one another", sound, picture.window);
  scene->SetBody(coupled);
  scene->ShowSession(pinch(coupled, 6.0));
  checkFaultShows("the lower finger elsewhere", sound, picture.window);
  scene->ShowSession(grip);
  checkSound(sound, picture.window);

  auto single = pinch(coupled, 0.0);
  single->Stop();
  single->RemoveAddedDevices();
  PALPATE_CHECK(single->Start());
  single->Step(0.4);
  scene->ShowSession(single); // the second tool and its dent have disappeared
  PALPATE_CHECK(caption(renderer).find("Hand 2") == std::string::npos);
  checkFaultShows("one finger", sound, picture.window);
  scene->ShowSession(grip);
  checkSound(sound, picture.window);
  return palpate::testing::result();
}
