// SPDX-License-Identifier: BSD-3-Clause
// The body of a scene that is drawn by shader. Each setting has the same effect as with the filter,
// whenever it is set. Also tested: bounds, two scenes at once, edges and anti-aliasing, and the
// picture of a dent.
#include "TwoPaths.h"

#include "vtkDoubleArray.h"
#include "vtkMapper.h"

namespace
{
using namespace palpate::testing;
using palpate::Vector3;

constexpr double Depth = 1.5;
constexpr double Rim = 24.0;  // mm, half the side of the box
constexpr double Color = 4.0; // see TestDeflectionShader.cxx for the reason

/// A box with points 0.6 mm apart.
Body box(const std::string& tool)
{
  return withResponse(boxBody(Rim, Rim, 8.0, 80), tool);
}

vtkSmartPointer<vtkContactScene> makeScene(vtkPolyData* body, const std::string& tool)
{
  auto scene = vtkSmartPointer<vtkContactScene>::New();
  scene->SetBody(body);
  scene->SetTool(makeTool(tool));
  scene->SetPoissonRatio(0.3);
  scene->SetLargestDeflection(Depth);
  return scene;
}

void showAt(vtkContactScene* scene, vtkPolyData* body, double x, double y)
{
  scene->ShowTip(probed(body, singleTip(x, y, 8.0 - Depth)), 0);
}

/// Checks that neither the colours without light nor the depths differ.
void checkSame(TwoPaths& paths, const std::string& after)
{
  const Deviation color(paths.colors(true, false), paths.colors(false, false), Color);
  const Deviation depth(paths.depths(true), paths.depths(false), 1e-3 * Depth);
  std::cout << after << ": colour " << color.largest << ", surface " << depth.largest << " mm"
            << std::endl;
  PALPATE_CHECK(color.share < 0.002 && depth.share < 0.002);
}

/// A setting between two frames takes effect in the next frame, both by shader and by filter.
void checkSettings()
{
  const Body body = box("sphere:6.35");
  auto scene = makeScene(body, "sphere:6.35");
  showAt(scene, body, 15.0, -4.0); // 9 mm from the rim: the field continues around it
  TwoPaths paths(scene, Vector3(12.0, -4.0, 8.0), Vector3(0.5, -0.6, 1.0), 14.0);
  checkSame(paths, "first");
  auto before = paths.depths(true);
  const auto changes = [&](const std::string& what)
  {
    checkSame(paths, what);
    const auto now = paths.depths(true);
    PALPATE_CHECK(Deviation(before, now).largest > 0.05 * Depth);
    before = now;
  };
  scene->SetExaggeration(2.5);
  changes("exaggeration");
  scene->SetTool(makeTool("flat:3"));
  changes("tool");
  scene->SetFieldRadius(6.0);
  changes("field radius");
  scene->SetFieldRadius(0.0);
  scene->SetTool(makeTool("cone:70"));
  showAt(scene, body, 10.0, 2.0);
  changes("contact");
  const auto colors = paths.colors(true, false);
  scene->SetLargestDeflection(0.4 * Depth);
  checkSame(paths, "legend");
  PALPATE_CHECK(Deviation(colors, paths.colors(true, false), Color).share > 0.1);
  scene->SetLargestDeflection(Depth);
  scene->SetPoissonRatio(0.0);
  checkSame(paths, "Poisson's ratio");
  PALPATE_CHECK(Deviation(colors, paths.colors(true, false), Color).share > 0.001);
  // The points of the body move. The scene detects this at the next contact.
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    x[2] += 0.5;
    body->GetPoints()->SetPoint(i, x);
  }
  body->GetPoints()->Modified();
  body->Modified();
  before = paths.depths(true);
  showAt(scene, body, 10.0, 2.0);
  changes("body");
  scene->ShowTip(probed(body, singleTip(0.0, 0.0, 30.0)), 0);
  changes("no contact");
  const auto flat = paths.colors(true, false);
  PALPATE_CHECK(*std::max_element(flat.begin(), flat.end()) < 255);
}

/// With other responses of the same surface, no data are computed or sent to the graphics card
/// again.
void checkSameSurface()
{
  const Body body = withResponse(planeBody(20.0, 40), "sphere:6.35");
  auto scene = makeScene(body, "sphere:6.35");
  vtkMapper* mapper = scene->GetBodyActor()->GetMapper();
  vtkDataSet* drawn = mapper->GetInput();
  scene->SetBody(withResponse(body, "flat:2"));
  PALPATE_CHECK(drawn && mapper->GetInput() == drawn);
  scene->SetDeflectionByShader(false);
  scene->SetDeflectionByShader(true);
  PALPATE_CHECK(scene->GetBodyActor()->GetMapper()->GetInput() == drawn);
  scene->SetBody(withResponse(planeBody(20.0, 40), "flat:2"));
  PALPATE_CHECK(mapper->GetInput() != drawn);
}

/// The bounds include the dent, so that no clipping plane cuts it off.
void checkBounds()
{
  const Body body = withResponse(planeBody(20.0, 40), "sphere:6.35");
  auto scene = makeScene(body, "sphere:6.35");
  const double* bounds = scene->GetBodyActor()->GetBounds();
  PALPATE_CHECK_NEAR(bounds[4], 0.0, 1e-6);
  scene->SetExaggeration(4.0);
  scene->ShowTip(probed(body, singleTip(1.0, 2.0, -Depth)), 0);
  bounds = scene->GetBodyActor()->GetBounds();
  PALPATE_CHECK_NEAR(bounds[4], -4.0 * Depth, 1e-6);
  PALPATE_CHECK_NEAR(bounds[5], 0.0, 1e-6);
  scene->ShowTip(probed(body, singleTip(1.0, 2.0, 5.0)), 0);
  PALPATE_CHECK_NEAR(scene->GetBodyActor()->GetBounds()[4], 0.0, 1e-6);
}

/// Two scenes in one window use one shader program, and each has its own dent.
void checkTwoScenes()
{
  const Body body = box("sphere:6.35");
  auto left = makeScene(body, "sphere:6.35");
  auto right = makeScene(body, "flat:2");
  showAt(left, body, 3.0, -4.0);
  showAt(right, body, -6.0, 5.0);
  const auto alone = [&](vtkContactScene* scene)
  {
    TwoPaths paths(scene, Vector3(0.0, 0.0, 8.0), Vector3(0.2, -0.3, 1.0), 20.0);
    return paths.depths(true);
  };
  const auto one = alone(left);
  const auto other = alone(right);
  PALPATE_CHECK(Deviation(one, other).largest > 0.5 * Depth);
  TwoPaths both(left, Vector3(0.0, 0.0, 8.0), Vector3(0.2, -0.3, 1.0), 20.0);
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.0, 0.0, 0.01, 0.01); // drawn, but outside the compared picture
  beside->AddActor(right->GetBodyActor());
  both.window()->AddRenderer(beside);
  both.depths(true);
  const auto together = both.depths(true);
  PALPATE_CHECK(Deviation(one, together, 1e-6).share < 0.001);
}

/// In some versions of VTK, edges need a geometry shader; FXAA needs a separate pass.
void checkEdges()
{
  const Body body = box("flat:3");
  auto scene = makeScene(body, "flat:3");
  showAt(scene, body, 3.0, -4.0);
  TwoPaths paths(scene, Vector3(3.0, -4.0, 8.0), Vector3(0.5, -0.6, 1.0), 8.0);
  scene->GetBodyActor()->GetProperty()->EdgeVisibilityOn();
  paths.renderer()->UseFXAAOn();
  // A line may be one pixel off, which the measure for pictures ignores.
  const auto shader = paths.picture(true);
  PALPATE_CHECK(difference(shader, paths.picture(false)) < PictureThreshold);
  scene->GetBodyActor()->GetProperty()->EdgeVisibilityOff();
  PALPATE_CHECK(difference(shader, paths.picture(true)) > 2.0 * PictureThreshold);
}

/// A flat punch on a curved body, exaggerated: wall, floor, field and light of the dent.
void checkPicture(int argc, char* argv[])
{
  const Body body = withResponse(bumpySphere(), "flat:4");
  auto scene = makeScene(body, "flat:4");
  scene->SetExaggeration(2.0);
  const auto press = [&](const Vector3& towards)
  {
    const Vector3 tip = 38.5 * towards.normalized();
    scene->ShowTip(probed(body, singleTip(tip.x(), tip.y(), tip.z())), 0);
  };
  press({ 0.2, -0.5, 0.8 });
  TwoPaths paths(scene, Vector3(4.0, -12.0, 24.0), Vector3(0.5, -0.7, 0.5), 26.0);
  const auto sound = paths.picture(true);
  PALPATE_CHECK(difference(sound, paths.picture(false)) < PictureThreshold);
  paths.picture(true);
  checkBaseline(paths.window(), argc, argv);
  press({ 0.2, -0.44, 0.8 });
  checkFaultShows("dent 2 mm aside", sound, paths.window());
}
} // namespace

int TestBodyDisplay(int argc, char* argv[])
{
  checkSettings();
  checkBounds();
  checkSameSurface();
  checkTwoScenes();
  checkEdges();
  checkPicture(argc, argv);
  return palpate::testing::result();
}
