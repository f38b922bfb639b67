// SPDX-License-Identifier: BSD-3-Clause
// A whole body with dent, tool, arrow, trail, legend and caption: the picture is compared with a
// baseline, and the values with the numbers.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkContactScene.h"
#include "vtkLookupTable.h"
#include "vtkScalarBarActor.h"

namespace
{
using namespace palpate::testing;

constexpr vtkIdType Pictured = 120; // tip of 242 in the middle of the slide
constexpr double Rounding = 1e-4;   // mm: coordinates of up to 60 mm in floats
constexpr double View[3] = { 0.2, -1.0, -0.3 };
constexpr double Up[3] = { 0.0, 0.0, 1.0 };

/// Returns the tube of the trail, which is the visible actor other than the body.
vtkActor* trailOf(vtkRenderer* renderer, vtkContactScene* scene)
{
  vtkActorCollection* actors = renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    if (actor != scene->GetBodyActor() && actor->GetVisibility())
    {
      return actor;
    }
  }
  return nullptr;
}

void checkTip(vtkContactScene* scene, vtkPolyData* tips, double scale)
{
  double tip[3];
  double contact[3];
  double normal[3];
  double force[3];
  vtkPointData* data = tips->GetPointData();
  tips->GetPoint(Pictured, tip);
  data->GetArray("ContactPoint")->GetTuple(Pictured, contact);
  data->GetArray("Normal")->GetTuple(Pictured, normal);
  data->GetArray("Force")->GetTuple(Pictured, force);
  const double magnitude = vtkMath::Normalize(force);
  PALPATE_CHECK(magnitude > 0.1);
  vtkHapticToolRepresentation* representation = scene->GetToolRepresentation();
  PALPATE_CHECK_NEAR(representation->GetForceScale(), scale, 1e-12 * scale);
  const ToolParts parts(representation);
  const Extent arrow = extentAlong(parts.arrow, contact, force);
  PALPATE_CHECK(parts.arrow->GetVisibility());
  PALPATE_CHECK_NEAR(arrow.low, 0.0, Rounding);
  PALPATE_CHECK_NEAR(arrow.high, scale * magnitude, Rounding);
  const Extent tool = extentAlong(parts.tool, tip, normal);
  PALPATE_CHECK_NEAR(tool.low, 0.0, Rounding);
  PALPATE_CHECK_NEAR(tool.high, representation->GetToolLength(), Rounding);
  PALPATE_CHECK_NEAR(tool.aside, 6.35, Rounding);
}

void checkTrail(vtkActor* trail, vtkPolyData* tips)
{
  PALPATE_CHECK(trail);
  vtkBoundingBox drawn(trail->GetBounds());
  vtkBoundingBox contacts;
  vtkPointData* data = tips->GetPointData();
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    if (data->GetArray("ContactCell")->GetTuple1(i) >= 0.0)
    {
      contacts.AddPoint(data->GetArray("ContactPoint")->GetTuple3(i));
    }
  }
  PALPATE_CHECK(contacts.GetMaxLength() > 20.0); // mm; without the approach and the lift
  double low[2][3];
  double high[2][3];
  drawn.GetBounds(low[0][0], high[0][0], low[0][1], high[0][1], low[0][2], high[0][2]);
  contacts.GetBounds(low[1][0], high[1][0], low[1][1], high[1][1], low[1][2], high[1][2]);
  for (int k = 0; k < 3; ++k)
  {
    PALPATE_CHECK_NEAR(low[0][k], low[1][k], 0.5 + Rounding); // the tube's radius
    PALPATE_CHECK_NEAR(high[0][k], high[1][k], 0.5 + Rounding);
  }
}

void checkErrors(vtkContactScene* scene, vtkPolyData* body, vtkPolyData* tips)
{
  Messages messages(scene);
  PALPATE_CHECK(!scene->ShowTip(tips, tips->GetNumberOfPoints()));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Tip 242 of 242");
  PALPATE_CHECK(!scene->ShowTip(tips, -1));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Tip -1");
  PALPATE_CHECK(!scene->ShowTip(body, 0) && !scene->ShowTrail(body));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "vtkToolContactProbe");
}
} // namespace

int TestContactSceneOverview(int argc, char* argv[])
{
  const Body body = withResponse(bumpySphere(), "sphere:6.35");
  const Body tips = probed(body, slidePath(body, { -0.5, -0.8, 0.6 }, { 0.6, -0.8, 0.5 }, 1.0));

  Picture picture(800, 600);
  auto renderer = picture.addRenderer();
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(body);
  scene->SetTool(makeTool("sphere:6.35"));
  scene->SetPoissonRatio(0.3);
  scene->SetLargestForce(18.0); // 40 mm / 18 N = 2.2 mm/N, rounded down: 2
  scene->SetLargestDeflection(1.2);
  scene->SetTitle("Bumpy sphere");
  PALPATE_CHECK(scene->ShowTip(tips, Pictured) && scene->ShowTrail(tips));
  scene->LookAtBody(View, Up);

  checkTip(scene, tips, 2.0);
  PALPATE_CHECK(isInPicture(renderer, scene->GetToolRepresentation()->GetBounds()));
  PALPATE_CHECK(isInPicture(renderer, body->GetBounds()));
  checkTrail(trailOf(renderer, scene), tips);
  double* range = scene->GetLegend()->GetLookupTable()->GetRange();
  PALPATE_CHECK(range[0] == 0.0 && range[1] == 1.2);
  PALPATE_CHECK_TEXT(caption(renderer), "Bumpy sphere\n", "Tool: sphere, radius 6.35 mm\n",
    "Deflection 1.00 mm, contact radius ", " mm\nForce 11.");
  PALPATE_CHECK(caption(renderer).find("validity") == std::string::npos);
  PALPATE_CHECK(caption(renderer).find("Dent drawn") == std::string::npos);
  checkErrors(scene, body, tips);

  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  ToolParts parts(scene->GetToolRepresentation());
  parts.arrow->VisibilityOff();
  checkFaultShows("no arrow", sound, picture.window);
  parts.arrow->VisibilityOn();
  vtkActor* trail = trailOf(renderer, scene);
  trail->VisibilityOff();
  checkFaultShows("no trail", sound, picture.window);
  trail->VisibilityOn();
  scene->ShowTip(tips, Pictured + 5);
  checkFaultShows("tool and dent 3 mm away", sound, picture.window);
  scene->ShowTip(tips, Pictured);
  scene->SetLargestDeflection(1200.0);
  checkFaultShows("legend in micrometres", sound, picture.window);
  scene->SetLargestDeflection(1.2);
  scene->GetLegend()->VisibilityOff();
  checkFaultShows("no legend", sound, picture.window);
  scene->GetLegend()->VisibilityOn();
  scene->SetLargestForce(19.0);
  scene->ShowTip(tips, Pictured);
  checkSound(sound, picture.window); // 2 mm/N, and colours up to 20 N, as before
  scene->SetLargestForce(18000.0);
  scene->ShowTip(tips, Pictured);
  checkFaultShows("force in millinewtons", sound, picture.window);
  return palpate::testing::result();
}
