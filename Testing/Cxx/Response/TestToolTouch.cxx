// SPDX-License-Identifier: BSD-3-Clause
// One touch and its display: forces by the tool's closed form, the position of the tip, the data of
// the four ports.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkFieldData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkToolTouch.h"

#include <limits>

namespace
{
using namespace palpate::testing;

constexpr double Modulus = 3.45; // E* of withResponse, MPa
constexpr double Range = 2.0;
// Error of stored floats and of the spline between samples. The spline is exact at samples, but
// half of the range is not a sample. For a paraboloid, whose law is a power, the samples reproduce
// the curve to float rounding.
constexpr double Stored = 1e-6;

double number(vtkToolTouch* touch, const char* name, int component = 0)
{
  vtkDataArray* array = touch->GetOutput(vtkToolTouch::ArrowPort)->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, component) : std::numeric_limits<double>::quiet_NaN();
}

std::string text(vtkToolTouch* touch)
{
  auto* table = vtkTable::SafeDownCast(touch->GetOutputDataObject(vtkToolTouch::TextPort));
  return table && table->GetNumberOfRows() == 1 ? table->GetValueByName(0, "Text").ToString() : "";
}

vtkSmartPointer<vtkToolTouch> touchOf(vtkPolyData* body, double x, double y, double z)
{
  auto touch = vtkSmartPointer<vtkToolTouch>::New();
  touch->SetInputData(body);
  touch->SetTipPosition(x, y, z);
  return touch;
}

/// Largest extent of the arrow from its tail along the force.
double arrowLength(vtkToolTouch* touch)
{
  vtkPolyData* arrow = touch->GetOutput(vtkToolTouch::ArrowPort);
  double longest = 0.0;
  for (vtkIdType i = 0; i < arrow->GetNumberOfPoints(); ++i)
  {
    double along = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double force = number(touch, "Force", c) / number(touch, "NormalForce");
      along += force * (arrow->GetPoint(i)[c] - number(touch, "TipPosition", c));
    }
    longest = std::max(longest, along);
  }
  return longest;
}

/// A paraboloid on a plane: the tip is snapped from far above to a depth of half the range, then
/// moved.
void checkForces()
{
  const Body body = withResponse(planeBody(20.0, 40), "paraboloid:5", Range);
  const auto tool = makeTool("paraboloid:5");
  const auto touch = touchOf(body, 1.3, -2.2, 30.0);
  touch->Update();
  const double half = tool->GetForce(0.5 * Range, Modulus);
  PALPATE_CHECK_NEAR(number(touch, "NormalForce"), half, Stored * half);
  PALPATE_CHECK_NEAR(number(touch, "Force", 2), half, Stored * half);
  PALPATE_CHECK_NEAR(number(touch, "Deflection"), 0.5 * Range, 1e-6); // the coordinates are floats
  const double slope = tool->GetStiffness(0.5 * Range, Modulus);
  PALPATE_CHECK_NEAR(
    // the stiffness is the derivative of the force
    number(touch, "Stiffness"), slope, 1e-5 * slope);
  PALPATE_CHECK_NEAR(number(touch, "TipPosition", 0), 1.3, 1e-12);
  PALPATE_CHECK_NEAR(number(touch, "TipPosition", 1), -2.2, 1e-12);
  PALPATE_CHECK_NEAR(number(touch, "TipPosition", 2), -0.5 * Range, 1e-6);
  const double scale = number(touch, "ForceScale");
  PALPATE_CHECK_NEAR(arrowLength(touch), scale * half, 1e-5 * scale * half);

  // The scale of the arrow is that of the body, so the arrow of a deeper press is longer in
  // proportion to the force.
  touch->SetTipPosition(-4.0, 3.0, -7.0);
  touch->SetIndentation(1.5);
  touch->Update();
  const double deep = tool->GetForce(1.5, Modulus);
  PALPATE_CHECK_NEAR(number(touch, "NormalForce"), deep, Stored * deep);
  PALPATE_CHECK_NEAR(number(touch, "ForceScale"), scale, 0.0);
  PALPATE_CHECK_NEAR(arrowLength(touch), scale * deep, 1e-5 * scale * deep);
  touch->SetForceScale(7.0);
  touch->Update();
  PALPATE_CHECK_NEAR(arrowLength(touch), 7.0 * deep, 1e-5 * 7.0 * deep);

  // Without Snap the tip stays at its position.
  touch->SnapOff();
  touch->SetIndentation(0.0);
  touch->SetTipPosition(0.4, 0.3, -0.7);
  touch->Update();
  const double shallow = tool->GetForce(0.7, Modulus);
  PALPATE_CHECK_NEAR(number(touch, "NormalForce"), shallow, Stored * shallow);
  touch->SetIndentation(0.3);
  touch->Update();
  const double more = tool->GetForce(1.0, Modulus);
  PALPATE_CHECK_NEAR(number(touch, "NormalForce"), more, Stored * more);
  PALPATE_CHECK_NEAR(number(touch, "TipPosition", 2), -1.0, 1e-6);
}

/// At a distance from the surface there is no force, and the text states the distance.
void checkNoContact()
{
  const Body body = withResponse(planeBody(20.0, 40), "paraboloid:5", Range);
  const auto touch = touchOf(body, 1.0, 2.0, 3.25);
  touch->SnapOff();
  touch->Update();
  PALPATE_CHECK_NEAR(number(touch, "NormalForce"), 0.0, 0.0);
  PALPATE_CHECK(touch->GetOutput(vtkToolTouch::ArrowPort)->GetNumberOfPoints() == 0);
  PALPATE_CHECK_TEXT(text(touch), "No contact", "3.25 mm off");
  vtkPolyData* dented = touch->GetOutput(vtkToolTouch::BodyPort);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    PALPATE_CHECK_NEAR(dented->GetPoint(i)[2], 0.0, 0.0);
  }
  double bounds[6];
  touch->GetOutput(vtkToolTouch::ToolPort)->GetBounds(bounds);
  PALPATE_CHECK_NEAR(bounds[4], 3.25, 1e-9); // the tool is drawn at its tip
}

/// The points move by the tool's own field. Arrays are passed on, the input is unchanged, and
/// normals are those of the deformed surface.
void checkDent()
{
  constexpr double Depth = 0.8;
  const Body plain = planeBody(20.0, 80);
  vtkNew<vtkFloatArray> up;
  up->SetName("Up");
  up->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
  {
    up->InsertNextTuple3(0.0, 0.0, 1.0);
  }
  plain->GetPointData()->SetNormals(up);
  const auto mine = pointArray(plain, "Mine", [](vtkIdType i) { return static_cast<double>(i); });
  plain->GetPointData()->SetActiveScalars("Mine");
  const Body body = withResponse(plain, "sphere:5", Range);
  const auto tool = makeTool("sphere:5");
  const auto touch = touchOf(body, 0.0, 0.0, 0.0);
  touch->SetIndentation(Depth);
  touch->SetReach(12.0);
  touch->Update();
  vtkPolyData* dented = touch->GetOutput(vtkToolTouch::BodyPort);
  PALPATE_CHECK(dented->GetPointData()->GetArray("Mine") == mine);
  PALPATE_CHECK(dented->GetPointData()->HasArray("ResponseForce"));
  vtkDataArray* dent = dented->GetPointData()->GetArray("Dent (mm)");
  PALPATE_CHECK(dent && dent == dented->GetPointData()->GetScalars());
  const double exact =
    0.75 * 12.0 * tool->GetContactRadius(Depth); // the field falls to zero beyond this distance
  int checked = 0;
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double was[3];
    double is[3];
    body->GetPoint(i, was);
    dented->GetPoint(i, is);
    PALPATE_CHECK_NEAR(was[2], 0.0, 0.0);
    const double r = std::hypot(was[0], was[1]);
    if (r > 0.99 * exact)
    {
      continue;
    }
    double u[2];
    tool->GetSurfaceDisplacement(r, Depth, 0.45, u);
    PALPATE_CHECK_NEAR(is[2], -u[1], 1e-6 * Depth); // 1e-6: stored as floats
    PALPATE_CHECK_NEAR(dent->GetTuple1(i), u[1], 1e-6 * Depth);
    ++checked;
  }
  PALPATE_CHECK(checked > 1000);

  // Near the contact the surface slopes down to the contact, so its normal is tilted towards the
  // contact.
  vtkDataArray* normals = dented->GetPointData()->GetNormals();
  PALPATE_CHECK(normals && normals != up);
  const vtkIdType beside = dented->vtkDataSet::FindPoint(3.0, 0.0, 0.0);
  PALPATE_CHECK(normals->GetComponent(beside, 0) < -0.02);
  PALPATE_CHECK(up->GetComponent(beside, 0) == 0.0);
  double below[2];
  double above[2];
  tool->GetSurfaceDisplacement(2.5, Depth, 0.45, below);
  tool->GetSurfaceDisplacement(3.5, Depth, 0.45, above);
  const double slope = std::atan2(below[1] - above[1], 1.0 + above[0] - below[0]);
  // The facets at a vertex extend 0.5 mm to each side. Their mean normal is weighted by area.
  PALPATE_CHECK_NEAR(normals->GetComponent(beside, 0), -std::sin(slope), 0.15 * std::sin(slope));
  const vtkIdType corner = dented->vtkDataSet::FindPoint(20.0, 20.0, 0.0);
  PALPATE_CHECK_NEAR(normals->GetComponent(corner, 2), 1.0, 0.0);
}

/// Two flat ends, alone and coupled by Boussinesq's 1/(π E* r).
void checkSecondTip()
{
  constexpr double Depth = 0.4;
  constexpr double Apart = 6.0;
  for (const bool isCoupled : { false, true })
  {
    vtkNew<vtkToolContactResponse> response;
    response->SetInputData(planeBody(20.0, 40));
    response->SetTool(makeTool("flat:2"));
    response->SetYoungsModulus(Modulus * 0.75);
    response->SetPoissonRatio(0.5);
    response->SetMaximumDeflection(Range);
    response->SetCoupling(isCoupled);
    response->Update();
    const auto touch = touchOf(response->GetOutput(), -3.0, 0.2, 50.0);
    touch->SetIndentation(Depth);
    touch->Update();
    const double alone = 4.0 * Modulus * Depth; // 2 a E* δ
    PALPATE_CHECK_NEAR(number(touch, "NormalForce"), alone, Stored * alone);
    const vtkIdType toolPoints = touch->GetOutput(vtkToolTouch::ToolPort)->GetNumberOfPoints();

    touch->SecondTipOn();
    touch->SetSecondTipPosition(Apart - 3.0, 0.2, 20.0);
    touch->Update();
    // stiffness K times coupling compliance C
    const double share = isCoupled ? 4.0 / (3.14159265358979323846 * Apart) : 0.0;
    vtkDataArray* forces =
      touch->GetOutput(vtkToolTouch::ArrowPort)->GetFieldData()->GetArray("NormalForce");
    PALPATE_CHECK(forces && forces->GetNumberOfTuples() == 2);
    for (vtkIdType i = 0; i < 2; ++i)
    {
      PALPATE_CHECK_NEAR(forces->GetTuple1(i), alone / (1.0 + share), 1e-5 * alone);
    }
    PALPATE_CHECK_NEAR(number(touch, "Deflection"), Depth / (1.0 + share), 1e-5);
    PALPATE_CHECK_NEAR(number(touch, "TipPosition", 2), -Depth, 1e-6);
    PALPATE_CHECK(touch->GetOutput(vtkToolTouch::ToolPort)->GetNumberOfPoints() == 2 * toolPoints);
    double bounds[6];
    touch->GetOutput(vtkToolTouch::ToolPort)->GetBounds(bounds);
    PALPATE_CHECK_NEAR(bounds[0], -5.0, 1e-5);
    PALPATE_CHECK_NEAR(bounds[1], 5.0, 1e-5);
    PALPATE_CHECK_TEXT(text(touch), "\nSecond tip\nForce ",
      isCoupled ? " less by the other tip" : "do not interact");
    vtkDataArray* dent =
      touch->GetOutput(vtkToolTouch::BodyPort)->GetPointData()->GetArray("Dent (mm)");
    const vtkIdType under = response->GetOutput()->vtkDataSet::FindPoint(-3.0, 0.0, 0.0);
    // The field of the other tip at this distance differs by 2 % from the coupling law, which is
    // that of a point force.
    PALPATE_CHECK_NEAR(dent->GetTuple1(under),
      isCoupled ? Depth : Depth * (1.0 + 4.0 / (3.14159265358979323846 * Apart)), 0.02 * Depth);
    touch->SecondTipOff();
    touch->Update();
    PALPATE_CHECK_NEAR(number(touch, "NormalForce"), alone, Stored * alone);
    touch->SecondTipOn();
    touch->SetSecondTipPosition(NAN, 0.0, 0.0);
    Messages messages(touch);
    touch->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), "Second Tip Position must be finite");
  }
}

/// A ball pressed from different sides: the tool is drawn along the radius of the ball, at its tip.
void checkTool()
{
  constexpr double Radius = 30.0;
  Body ball = sphereBody(Radius, 4);
  addRadialNormals(ball);
  const Body body = withResponse(ball, "sphere:4", Range);
  for (const std::array<double, 3> way :
    { std::array<double, 3>{ 0.0, 0.0, -1.0 }, { 0.6, 0.0, 0.8 }, { -0.6, 0.64, -0.48 } })
  {
    const auto touch = touchOf(body, 50.0 * way[0], 50.0 * way[1], 50.0 * way[2]);
    touch->SetToolLength(20.0);
    touch->Update();
    vtkPolyData* shape = touch->GetOutput(vtkToolTouch::ToolPort);
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
    {
      const double height = vtkMath::Dot(shape->GetPoint(i), way.data());
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    // The facets of the ball are up to 0.04 mm inside it. Their blended normals have an error of
    // 0.02.
    PALPATE_CHECK_NEAR(lowest, Radius - 0.5 * Range, 0.05);
    PALPATE_CHECK_NEAR(highest, Radius - 0.5 * Range + 20.0, 0.1);
    PALPATE_CHECK_TEXT(
      text(touch), "sphere, radius 4 mm", "Force", " N", "Deflection 1.00 mm", "N/mm", "mm per N");
  }
}

/// The text states whether the force is valid.
void checkValidity()
{
  const Body body = withResponse(planeBody(20.0, 40), "sphere:5", Range);
  const auto touch = touchOf(body, 0.0, 0.0, 0.0);
  const double limit = body->GetPointData()->GetArray("ResponseValidity")->GetTuple1(0);
  touch->SetIndentation(0.5 * limit);
  touch->Update();
  PALPATE_CHECK_TEXT(text(touch), "Within the law's validity", "strain");
  PALPATE_CHECK_NEAR(number(touch, "Validity"), limit, 0.0);
  touch->SetIndentation(1.5 * limit);
  touch->Update();
  PALPATE_CHECK_TEXT(text(touch), "Beyond the law's validity", "strain");
  touch->SetIndentation(1.5 * Range);
  touch->Update();
  PALPATE_CHECK_TEXT(text(touch), "deeper than the response reaches, 2.00 mm");
}

void checkErrors()
{
  const Body plain = planeBody(20.0, 10);
  {
    const auto touch = touchOf(plain, 0.0, 0.0, 0.0);
    Messages messages(touch);
    touch->Update();
    PALPATE_CHECK_TEXT(messages.takeErrors(), "ResponseSamples", "Tool Contact Response first");
  }
  const Body body = withResponse(plain, "sphere:5", Range);
  const auto touch = touchOf(body, 0.0, 0.0, 0.0);
  Messages messages(touch);
  touch->SetResponseName("Flat");
  touch->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "no response 'Flat'", "the body has 'Response'");
  touch->SetResponseName("Response");
  touch->SetIndentation(-1.0);
  touch->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Indentation", "-1");
  touch->SetIndentation(0.0);
  touch->SetTipPosition(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  touch->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Tip Position", "nan");
  touch->SetTipPosition(0.0, 0.0, 0.0);
  touch->SetReach(0.0);
  touch->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Reach");
  touch->SetReach(20.0);
  touch->SetPoissonRatio(0.6);
  touch->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Poisson's Ratio", "0.6");
  touch->SetPoissonRatio(0.45);
  touch->SetForceScale(-2.0);
  touch->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Force Scale", "-2");
  touch->SetForceScale(0.0);
  touch->Update();
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK(number(touch, "NormalForce") > 0.0);

  // Another body at the same place is used without any further call.
  touch->SetInputData(withResponse(planeBody(20.0, 10, 3.0), "flat:2", Range));
  touch->Update();
  PALPATE_CHECK_NEAR(number(touch, "TipPosition", 2), 2.0, 1e-6);
  const double flat = makeTool("flat:2")->GetForce(1.0, Modulus);
  PALPATE_CHECK_NEAR(number(touch, "NormalForce"), flat, Stored * flat);

  vtkNew<vtkPolyData> empty;
  touch->SetInputData(empty);
  touch->Update();
  PALPATE_CHECK(messages.none());
  PALPATE_CHECK(touch->GetOutput()->GetNumberOfPoints() == 0);
}
} // namespace

int TestToolTouch(int, char*[])
{
  checkForces();
  checkNoContact();
  checkDent();
  checkSecondTip();
  checkTool();
  checkValidity();
  checkErrors();
  return result();
}
