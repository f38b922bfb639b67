// SPDX-License-Identifier: BSD-3-Clause
// Three tools at the same place on a cylinder, with one scene each, side by side with the same
// scale of force.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkContactScene.h"
#include "vtkScalarBarActor.h"

#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Depth = 1.0;
const char* const Tools[3] = { "flat:1.6", "sphere:6.35", "cone:60" };

/// Tolerance of deflection and contact on the tube's facets of 1 mm, which are up to
/// h²/(8R) = 0.0025 mm below the arc.
constexpr double Facet = 0.003;

/// The scene of one tool, and its data.
struct Column
{
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkContactScene> scene;
  Body tip;
  double force;
};

void checkColumn(const Column& column, const char* description)
{
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double top[3] = { 0.0, 0.0, 50.0 };
  const ToolParts parts(column.scene->GetToolRepresentation());
  const Extent arrow = extentAlong(parts.arrow, top, up);
  PALPATE_CHECK_NEAR(column.scene->GetToolRepresentation()->GetForceScale(), 2.0, 1e-12);
  PALPATE_CHECK_NEAR(arrow.low, 0.0, Facet);
  PALPATE_CHECK_NEAR(arrow.high - arrow.low, 2.0 * column.force, 1e-4);
  const Extent tool = extentAlong(parts.tool, top, up);
  PALPATE_CHECK_NEAR(tool.low, -Depth, 1e-4);
  PALPATE_CHECK_NEAR(tool.high, 22.0 - Depth, 1e-4);
  PALPATE_CHECK_TEXT(caption(column.renderer), description, "Deflection 1.00 mm");
  // The legend has the same width in pixels in a narrow viewport as in a wide viewport, and is
  // inside the viewport.
  const double left = column.scene->GetLegend()->GetPositionCoordinate()->GetValue()[0];
  const double width = column.scene->GetLegend()->GetWidth();
  PALPATE_CHECK_NEAR((1.0 - left) * column.renderer->GetSize()[0], 175.0, 1.0);
  PALPATE_CHECK(left >= 0.0 && left + width <= 1.0);
}
} // namespace

int TestContactSceneSideBySide(int argc, char* argv[])
{
  const Body tube = tubeBody(50.0, 80.0);
  Picture picture(1200, 480);
  const double view[3] = { 0.35, -0.9, 0.75 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  std::vector<Column> columns;
  for (int i = 0; i < 3; ++i)
  {
    const Body body = withResponse(tube, Tools[i]);
    Column column{ picture.addRenderer(i / 3.0, (i + 1) / 3.0), nullptr, nullptr, 0.0 };
    column.tip = probed(body, singleTip(0.0, 0.0, 50.0 - Depth));
    column.force = column.tip->GetPointData()->GetArray("NormalForce")->GetTuple1(0);
    column.scene = vtkSmartPointer<vtkContactScene>::New();
    column.scene->SetRenderer(column.renderer);
    column.scene->SetBody(body);
    column.scene->SetTool(makeTool(Tools[i]));
    column.scene->SetPoissonRatio(0.0);
    column.scene->SetLargestForce(12.0);
    column.scene->SetLargestDeflection(Depth);
    PALPATE_CHECK(column.scene->ShowTip(column.tip, 0));
    column.scene->LookAtContact(140.0, view, up);
    columns.push_back(column);
  }
  // E* = 3.45 MPa on a half-space: 2 E* a d for the flat, 4/3 E* sqrt(R) d^1.5 for the paraboloid
  // (a sphere is 2 % softer), 2/pi E* tan(60) d^2 for the cone. d is up to Facet smaller than
  // Depth.
  const double d = Depth - Facet / 2.0;
  PALPATE_CHECK_NEAR(columns[0].force, 2.0 * 3.45 * 1.6 * d, 0.02);
  PALPATE_CHECK_NEAR(columns[1].force, 0.98 * 4.0 / 3.0 * 3.45 * std::sqrt(6.35), 0.1);
  PALPATE_CHECK_NEAR(columns[2].force, 2.0 / vtkMath::Pi() * 3.45 * std::sqrt(3.0) * d * d, 0.02);
  checkColumn(columns[0], "Tool: flat, radius 1.6 mm");
  checkColumn(columns[1], "Tool: sphere, radius 6.35 mm");
  checkColumn(columns[2], "Tool: cone, half angle 60 degrees");

  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);
  columns[2].scene->SetTool(makeTool("cone:70"));
  checkFaultShows("another cone", sound, picture.window);
  columns[2].scene->SetTool(makeTool("cone:60"));
  columns[0].scene->SetLargestForce(columns[0].force);
  columns[0].scene->ShowTip(columns[0].tip, 0);
  checkSound(sound, picture.window); // the rounded scale has not changed
  columns[2].scene->SetLargestForce(columns[2].force);
  columns[2].scene->ShowTip(columns[2].tip, 0);
  checkFaultShows("arrows at different scales", sound, picture.window);
  return palpate::testing::result();
}
