// SPDX-License-Identifier: BSD-3-Clause
// A close-up of the dent in a plane, at its true depth and exaggerated. The drawn displacement is
// compared with the half-space field of the tool. The picture is compared with a baseline.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkContactScene.h"
#include "vtkLookupTable.h"
#include "vtkProperty.h"
#include "vtkScalarBarActor.h"

namespace
{
using namespace palpate::testing;

constexpr double Depth = 1.5;
constexpr double Poisson = 0.3;
constexpr double Rounding = 2e-5; // mm: coordinates of 20 mm in floats

/// Checks that every point of the plane is moved by the field of the tool times the exaggeration.
void checkDent(vtkContactScene* scene, vtkPolyData* body, vtkContactTool* tool, double exaggeration)
{
  vtkMapper* mapper = scene->GetBodyActor()->GetMapper();
  mapper->Update();
  auto* drawn = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  PALPATE_CHECK(drawn->GetNumberOfPoints() == body->GetNumberOfPoints());
  double deepest = 0.0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double moved[3];
    body->GetPoint(i, p);
    drawn->GetPoint(i, moved);
    const double r = std::hypot(p[0], p[1]);
    double u[2];
    tool->GetSurfaceDisplacement(r, Depth, Poisson, u);
    const double outward = r > 0.0 ? exaggeration * u[0] / r : 0.0;
    PALPATE_CHECK_NEAR(moved[0], p[0] * (1.0 + outward), exaggeration * Rounding);
    PALPATE_CHECK_NEAR(moved[1], p[1] * (1.0 + outward), exaggeration * Rounding);
    PALPATE_CHECK_NEAR(moved[2], p[2] - exaggeration * u[1], exaggeration * Rounding);
    deepest = std::max(deepest, -moved[2]);
  }
  PALPATE_CHECK_NEAR(deepest, exaggeration * Depth, exaggeration * Rounding);
  // The colour is the true displacement for any exaggeration.
  PALPATE_CHECK(std::string(mapper->GetArrayName()) == "ContactDisplacement");
  double range[2];
  drawn->GetPointData()->GetArray("ContactDisplacement")->GetRange(range, -1);
  PALPATE_CHECK_NEAR(range[1], Depth, Rounding);
}

/// The lightness decreases over the whole scale, so that the scale can also be read in grey.
void checkColors(vtkScalarsToColors* colors)
{
  double before = 2.0;
  for (int i = 0; i <= 100; ++i)
  {
    double rgb[3];
    colors->GetColor(Depth * i / 100.0, rgb);
    const double luminance = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    PALPATE_CHECK(luminance <= before);
    before = luminance;
  }
  PALPATE_CHECK(before < 0.1);
}
} // namespace

int TestContactSceneDeflection(int argc, char* argv[])
{
  const Body body = withResponse(planeBody(30.0, 90), "sphere:6.35");
  const Body tip = probed(body, singleTip(0.0, 0.0, -Depth));
  const auto tool = makeTool("sphere:6.35");

  Picture picture(640, 480);
  auto renderer = picture.addRenderer();
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(body);
  scene->SetTool(tool);
  scene->SetPoissonRatio(Poisson);
  scene->SetLargestForce(30.0);
  scene->SetLargestDeflection(Depth);
  scene->SetDeflectionByShader(false); // the test needs the displaced geometry of the filter
  PALPATE_CHECK(scene->GetExaggeration() == 1.0);
  PALPATE_CHECK(scene->ShowTip(tip, 0));
  checkDent(scene, body, tool, 1.0);
  checkColors(scene->GetLegend()->GetLookupTable());
  PALPATE_CHECK_TEXT(caption(renderer), "Deflection 1.50 mm");
  PALPATE_CHECK(caption(renderer).find("Dent drawn") == std::string::npos);
  const double from[3] = { 0.3, -0.8, 0.6 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  scene->LookAtContact(75.0, from, up);

  scene->SetExaggeration(3.0);
  PALPATE_CHECK(scene->ShowTip(tip, 0));
  checkDent(scene, body, tool, 3.0);
  PALPATE_CHECK_TEXT(caption(renderer), "Deflection 1.50 mm", "\nDent drawn x3");
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  scene->SetExaggeration(1.0);
  checkFaultShows("dent at its true depth where 3 times is said", sound, picture.window);
  scene->SetExaggeration(3.0);
  const Body aside = probed(body, singleTip(2.0, 0.0, -Depth));
  scene->ShowTip(aside, 0);
  checkFaultShows("dent 2 mm aside", sound, picture.window);
  scene->ShowTip(tip, 0);
  scene->SetLargestDeflection(0.8 * Depth);
  checkFaultShows("legend ends at 1.2 mm for 1.5 mm", sound, picture.window);
  scene->SetLargestDeflection(Depth);
  scene->GetBodyActor()->GetMapper()->ScalarVisibilityOff();
  checkFaultShows("no colours", sound, picture.window);
  scene->GetBodyActor()->GetMapper()->ScalarVisibilityOn();
  scene->SetTool(makeTool("sphere:8"));
  checkFaultShows("field of another tool", sound, picture.window);
  scene->SetTool(tool);
  scene->SetPoissonRatio(0.5);
  checkFaultShows("another Poisson's ratio", sound, picture.window);
  scene->SetPoissonRatio(Poisson);
  checkSound(sound, picture.window);
  return palpate::testing::result();
}
