// SPDX-License-Identifier: BSD-3-Clause
// A tilted flat end on a block: the tool along its axis, the dent, the arc of its torque and the
// caption. An upright tool has no arc.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkContactScene.h"
#include "vtkToolContactResponse.h"

namespace
{
using namespace palpate::testing;

constexpr double View[3] = { 0.25, -1.0, 0.4 };
constexpr double Up[3] = { 0.0, 0.0, 1.0 };

/// Returns the probed contact of one tip in the middle, pressed `depth` mm deep and tilted towards
/// +x.
Body leaning(vtkPolyData* body, double depth, double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.2, 0.3, -depth);
  Body tips = Body::New();
  tips->SetPoints(points);
  vtkNew<vtkDoubleArray> axis;
  axis->SetName("ToolAxis");
  axis->SetNumberOfComponents(3);
  axis->InsertNextTuple3(std::sin(angle), 0.0, std::cos(angle));
  tips->GetPointData()->AddArray(axis);
  return probed(body, tips);
}
} // namespace

int TestContactSceneTilt(int argc, char* argv[])
{
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(planeBody(30.0, 60));
  filter->SetTool(makeTool("flat:4"));
  filter->SetYoungsModulus(0.1);
  filter->SetMaximumDeflection(2.0);
  filter->SetMaximumTilt(20.0);
  filter->Update();
  const Body body = filter->GetOutput();

  Picture picture(800, 600);
  auto renderer = picture.addRenderer();
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(body);
  scene->SetTool(makeTool("flat:4"));
  scene->SetLargestForce(2.0);
  scene->SetLargestDeflection(2.0);
  scene->SetTitle("A flat end that leans");

  PALPATE_CHECK(scene->ShowTip(leaning(body, 1.0, 0.0), 0));
  PALPATE_CHECK(caption(renderer).find("Tilted") == std::string::npos);
  scene->LookAtBody(View, Up);

  const Body tips = leaning(body, 0.6, 12.0);
  PALPATE_CHECK(scene->ShowTip(tips, 0));
  PALPATE_CHECK_TEXT(caption(renderer), "Tilted by 12.0 degrees, torque ", " N mm");
  const ToolParts parts(scene->GetToolRepresentation());
  const double along[3] = { std::sin(vtkMath::RadiansFromDegrees(12.0)), 0.0,
    std::cos(vtkMath::RadiansFromDegrees(12.0)) };
  double tip[3];
  tips->GetPoint(0, tip);
  const Extent tool = extentAlong(parts.tool, tip, along);
  PALPATE_CHECK_NEAR(tool.low, 0.0, 1e-4); // coordinates of about 30 mm in floats
  PALPATE_CHECK_NEAR(tool.high, scene->GetToolRepresentation()->GetToolLength(), 1e-4);
  PALPATE_CHECK_NEAR(tool.aside, 4.0, 1e-4);
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);
  scene->ShowTip(leaning(body, 0.6, 0.0), 0);
  checkFaultShows("upright", sound, picture.window);
  scene->ShowTip(leaning(body, 0.6, -12.0), 0);
  checkFaultShows("leaning the other way", sound, picture.window);
  scene->ShowTip(tips, 0);
  checkSound(sound, picture.window);
  return palpate::testing::result();
}
