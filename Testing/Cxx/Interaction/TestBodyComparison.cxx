// SPDX-License-Identifier: BSD-3-Clause
// Two plates of the same material, one of which has a global compliance. The results are compared
// with the closed forms of the series model. The drawing is also tested.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkActor.h"
#include "vtkAxis.h"
#include "vtkBodyComparison.h"
#include "vtkChartXY.h"
#include "vtkContactScene.h"
#include "vtkDataObject.h"
#include "vtkPlot.h"
#include "vtkRegimeMap.h"
#include "vtkResponseChart.h"

#include <cmath>
#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Modulus = 3.45;    // E*, MPa, with ν = 0
constexpr double Compliance = 10.0; // compliance of the left body, mm/N
constexpr double Depth = 1.0;
constexpr double Range = 1.5;
constexpr int Left = vtkBodyComparison::Left;
constexpr int Right = vtkBodyComparison::Right;

struct Tool
{
  const char* specification;
  double size; // mm
};
const Tool Tools[3] = { { "paraboloid:6.35", 6.35 }, { "paraboloid:1.6", 1.6 },
  { "flat:1.6", 1.6 } };

bool isFlat(int tool)
{
  return tool == 2;
}

/// F = k d^m for a tool on a half-space.
double halfSpaceForce(int tool, double depth)
{
  const double size = Tools[tool].size;
  return isFlat(tool) ? 2.0 * Modulus * size * depth
                      : 4.0 / 3.0 * Modulus * std::sqrt(size) * std::pow(depth, 1.5);
}

/// Returns the force in series with a compliance, by bisection of the local depth.
double seriesForce(int tool, double depth, double compliance)
{
  double low = 0.0;
  double high = depth;
  for (int i = 0; i < 100; ++i)
  {
    const double local = 0.5 * (low + high);
    (local + compliance * halfSpaceForce(tool, local) < depth ? low : high) = local;
  }
  return halfSpaceForce(tool, low);
}

/// dlnF/dln(size) in the series model: 1 - λ for a flat, (1 - λ)/(2 + λ) for a paraboloid.
double seriesSensitivity(int tool, double index)
{
  return isFlat(tool) ? 1.0 - index : (1.0 - index) / (2.0 + index);
}

/// A square with the responses of all tools; points 1 mm apart.
Body makeBody(double compliance)
{
  Body body = planeBody(20.0, 40);
  if (compliance > 0.0)
  {
    pointArray(body, "GlobalCompliance", [compliance](vtkIdType) { return compliance; });
  }
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkToolContactResponse> filter;
    filter->SetInputData(body);
    filter->SetTool(makeTool(Tools[i].specification));
    filter->SetYoungsModulus(Modulus);
    filter->SetPoissonRatio(0.0);
    filter->SetMaximumDeflection(Range);
    filter->SetResponseName("Response" + std::to_string(i + 1));
    makePlain(filter);
    if (compliance > 0.0)
    {
      filter->SetInputArrayToProcess(
        2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "GlobalCompliance");
    }
    filter->Update();
    body = Body::New();
    body->ShallowCopy(filter->GetOutput());
  }
  return body;
}

void checkSide(vtkBodyComparison* comparison, int side, double compliance, double depth)
{
  double least = 1e9;
  double largest = 0.0;
  double sum = 0.0;
  for (int tool = 0; tool < 3; ++tool)
  {
    const double force = seriesForce(tool, depth, compliance);
    const double index = compliance * force / depth;
    // The response is stored in eight samples, which gives an error of up to 0.5 % in series. See
    // the manual, Reference/times.md.
    PALPATE_CHECK_NEAR(comparison->GetForce(side, tool), force, 0.005 * force);
    // Index and sensitivity are not computed from the stored curves. The tolerance is for float
    // arrays and a central difference with an error of 2e-5.
    PALPATE_CHECK_NEAR(comparison->GetRegimeIndex(side, tool), index, 1e-5);
    PALPATE_CHECK_NEAR(
      comparison->GetToolSensitivity(side, tool), seriesSensitivity(tool, index), 5e-5);
    least = std::min(least, force);
    largest = std::max(largest, force);
    sum += force;
  }
  const double spread = 3.0 * (largest - least) / sum;
  // Tolerance for the stored forces.
  PALPATE_CHECK_NEAR(comparison->GetForceSpread(side), spread, 0.006);
}

/// Depth at which the verdict for a paraboloid changes from mixed to "a point force suffices". It
/// follows from 4^S = 1.05, S = (1 - λ)/(2 + λ) and λδ = C k ((1 - λ)δ)^1.5.
double pointForceFrom(double size, double compliance)
{
  const double sensitivity = std::log(1.05) / std::log(4.0);
  const double index = (1.0 - 2.0 * sensitivity) / (1.0 + sensitivity);
  const double k = 4.0 / 3.0 * Modulus * std::sqrt(size);
  return std::pow(index / (compliance * k * std::pow(1.0 - index, 1.5)), 2.0);
}

/// The verdicts follow from the largest sensitivity. The range of depths of a verdict ends where
/// this sensitivity crosses the bound.
void checkVerdicts(vtkBodyComparison* comparison)
{
  double range[2];
  PALPATE_CHECK(comparison->GetVerdict(Right) == 0);
  comparison->GetVerdictRange(Right, range);
  PALPATE_CHECK_NEAR(range[0], 0.0, 1e-12);
  PALPATE_CHECK_NEAR(range[1], Range, 1e-6); // rounding of floats
  PALPATE_CHECK_TEXT(comparison->GetStatement(Right), "The shape of the tool matters.",
    "At 1.00 mm", "size sensitivity 0.50 to 1.00");

  PALPATE_CHECK(comparison->GetVerdict(Left) == 2);
  comparison->GetVerdictRange(Left, range);
  // The smallest paraboloid is the last tool for which a point force suffices. Verdicts are
  // computed at intervals of 1/160 of √Range.
  const double from = pointForceFrom(1.6, Compliance);
  PALPATE_CHECK(from > 0.05 && from < Depth); // otherwise nothing is tested
  PALPATE_CHECK(range[0] >= from && range[0] <= from + 2.0 * std::sqrt(from * Range) / 100.0);
  PALPATE_CHECK_NEAR(range[1], Range, 1e-6);
  PALPATE_CHECK_TEXT(comparison->GetStatement(Left), "A point force suffices", "The same from");

  // A depth at which a point force does not yet suffice.
  comparison->SetDeflection(0.8 * from);
  PALPATE_CHECK(comparison->ShowPlace(0.0, 0.0, 0.0));
  PALPATE_CHECK(comparison->GetVerdict(Left) == 1);
  comparison->GetVerdictRange(Left, range);
  PALPATE_CHECK(range[0] < 0.8 * from && range[1] < from);
  comparison->SetDeflection(Depth);
}

/// Checks the validity by strain, for the smallest paraboloid (a/R = 0.4: δ = 0.16 R) on the
/// half-space.
void checkValidity(vtkBodyComparison* comparison)
{
  PALPATE_CHECK_NEAR(comparison->GetValidity(Right), 0.16 * 1.6, 1e-6);
}

void checkErrors()
{
  vtkNew<vtkBodyComparison> comparison;
  Messages messages(comparison.Get());
  PALPATE_CHECK(!comparison->ShowPlace(0.0, 0.0, 0.0));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "no body");
  const Body bare = planeBody(10.0, 2);
  comparison->SetBody(Left, bare, "bare");
  comparison->SetBody(Right, bare, "bare");
  PALPATE_CHECK(!comparison->ShowPlace(0.0, 0.0, 0.0));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "no tool");
  comparison->AddTool(makeTool("flat:1.6"), "Nowhere");
  PALPATE_CHECK(!comparison->ShowPlace(0.0, 0.0, 0.0));
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Nowhere");
  comparison->SetDeflection(-1.0);
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Deflection", "-1");
  PALPATE_CHECK(comparison->GetVerdict(Left) == -1);
  PALPATE_CHECK(std::isnan(comparison->GetForce(Left, 0)));
  PALPATE_CHECK(comparison->GetStatement(Left).empty());
}
} // namespace

int TestBodyComparison(int argc, char* argv[])
{
  checkErrors();
  const Body bodies[2] = { makeBody(Compliance), makeBody(0.0) };
  Picture picture(1280, 960);
  vtkNew<vtkBodyComparison> comparison;
  comparison->SetRenderWindow(picture.window);
  comparison->SetYoungsModulus(Modulus);
  comparison->SetPoissonRatio(0.0);
  comparison->SetDeflection(Depth);
  comparison->SetBody(Left, bodies[0], "In series with 10 mm/N");
  comparison->SetBody(Right, bodies[1], "Half-space");
  for (int i = 0; i < 3; ++i)
  {
    comparison->AddTool(makeTool(Tools[i].specification), "Response" + std::to_string(i + 1));
  }
  PALPATE_CHECK(comparison->GetNumberOfTools() == 3);
  const Body tips = singleTip(0.1, 0.2, -Depth);
  const Body probed[2] = { palpate::testing::probed(bodies[0], tips, "Response1"),
    palpate::testing::probed(bodies[1], tips, "Response1") };
  PALPATE_CHECK(comparison->ShowTips(probed[0], probed[1], 0));
  checkSide(comparison, Left, Compliance, Depth);
  checkSide(comparison, Right, 0.0, Depth);
  checkValidity(comparison);
  checkVerdicts(comparison);
  comparison->SetDeflection(0.3);
  PALPATE_CHECK(comparison->ShowPlace(5.0, 5.0, 0.0));
  checkSide(comparison, Left, Compliance, 0.3);
  comparison->SetDeflection(Depth);

  // Both views share one camera.
  PALPATE_CHECK(comparison->GetRenderer(Left)->GetActiveCamera() ==
    comparison->GetRenderer(Right)->GetActiveCamera());
  PALPATE_CHECK(comparison->ShowTips(probed[0], probed[1], 0));
  const double view[3] = { 0.25, -0.9, 0.42 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  comparison->LookAtBodies(view, up);
  const auto sound = draw(picture.window);
  checkBaseline(picture.window, argc, argv);

  comparison->SetShownTool(2);
  checkFaultShows("another tool", sound, picture.window);
  comparison->SetShownTool(0);
  for (const int color : { vtkBodyComparison::RegimeIndex, vtkBodyComparison::ToolSensitivity,
         vtkBodyComparison::RegimeVerdict })
  {
    PALPATE_CHECK(comparison->SetColor(color));
    PALPATE_CHECK(!comparison->GetScene(Left)->GetBodyActor()->GetVisibility());
    checkFaultShows("another colour", sound, picture.window);
  }
  comparison->SetColor(vtkBodyComparison::Displacement);
  checkSound(sound, picture.window);
  comparison->SetBody(Left, bodies[1], "In series with 10 mm/N");
  comparison->ShowTips(probed[1], probed[1], 0);
  checkFaultShows("the other body's curves", sound, picture.window);
  return palpate::testing::result();
}
