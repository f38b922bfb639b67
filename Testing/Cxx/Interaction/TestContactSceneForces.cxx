// SPDX-License-Identifier: BSD-3-Clause
// The drawn forces of a tool that slides with friction beyond validity: arrows, applied force,
// circle, trail and scale, each compared with the numbers. The picture is compared with a baseline.
#include "Picture.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkContactScene.h"
#include "vtkIdList.h"
#include "vtkLookupTable.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkScalarBarActor.h"

#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Radius = 6.35;
constexpr double Friction = 0.4;
constexpr double Rounding = 1e-4; // mm: geometry in floats

/// Validity by strain ends at a = 0.4 R. The deflection of the exact sphere is then a/2
/// ln((R+a)/(R-a)).
const double ValidDepth = 0.2 * Radius * std::log(1.4 / 0.6);

/// A path down to 1.5 mm, beyond ValidDepth, and then 16 mm along x, probed with friction. The
/// device applies a third of the force.
Body slide(vtkPolyData* body)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(41);
  for (int i = 0; i <= 40; ++i)
  {
    const double depth = std::min(0.15 * i, 1.5);
    line->InsertCellPoint(points->InsertNextPoint(-8.0 + 0.4 * i, 0.3, -depth));
  }
  auto tips = Body::New();
  tips->SetPoints(points);
  tips->SetLines(line);
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(0, body);
  probe->SetTipData(tips);
  probe->SetFrictionCoefficient(Friction);
  probe->SetTangentialStiffness(100.0);
  probe->Update();
  Body felt = probe->GetOutput();
  vtkNew<vtkDoubleArray> applied;
  applied->SetName("AppliedForce");
  applied->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < felt->GetNumberOfPoints(); ++i)
  {
    double force[3];
    felt->GetPointData()->GetArray("Force")->GetTuple(i, force);
    vtkMath::MultiplyScalar(force, 1.0 / 3.0);
    applied->InsertNextTuple(force);
  }
  felt->GetPointData()->AddArray(applied);
  return felt;
}

/// Length of an arrow's axis that is covered by its shaft, without the head, mm.
double coveredBy(vtkActor* arrow, double neck)
{
  arrow->GetMapper()->Update();
  auto* drawn = vtkPolyData::SafeDownCast(arrow->GetMapper()->GetInputDataObject(0, 0));
  double covered = 0.0;
  for (vtkIdType i = 0; i < drawn->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    drawn->GetCellBounds(i, bounds);
    // Strips of the tube along x. The 32 strips of a dash have the same length.
    covered += bounds[1] <= neck + Rounding ? (bounds[1] - bounds[0]) / 32.0 : 0.0;
  }
  return covered;
}

void checkArrow(vtkActor* arrow, vtkTextActor* label, const double from[3], const double force[3],
  double scale, const std::string& text)
{
  double direction[3] = { force[0], force[1], force[2] };
  const double magnitude = vtkMath::Normalize(direction);
  PALPATE_CHECK(arrow->GetVisibility() && label->GetVisibility());
  const Extent extent = extentAlong(arrow, from, direction);
  PALPATE_CHECK_NEAR(extent.low, 0.0, Rounding);
  PALPATE_CHECK_NEAR(extent.high, scale * magnitude, Rounding);
  char number[40];
  std::snprintf(number, sizeof number, "%s%#.3g N", text.c_str(), magnitude);
  PALPATE_CHECK(std::string(label->GetInput()) == number);
}

void checkForces(vtkContactScene* scene, vtkPolyData* tips, vtkIdType tip)
{
  const ForceParts parts(scene->GetToolRepresentation());
  vtkPointData* data = tips->GetPointData();
  double contact[3];
  double force[3];
  double rubbing[3];
  double normal[3];
  data->GetArray("ContactPoint")->GetTuple(tip, contact);
  data->GetArray("Force")->GetTuple(tip, force);
  data->GetArray("FrictionForce")->GetTuple(tip, rubbing);
  vtkMath::Subtract(force, rubbing, normal);
  // The contact slides along x: the friction is Coulomb's, against the motion.
  PALPATE_CHECK_NEAR(rubbing[0], -Friction * normal[2], 1e-6);
  const double scale = scene->GetToolRepresentation()->GetForceScale();
  checkArrow(parts.total, parts.totalLabel, contact, force, scale, "");
  checkArrow(parts.normal, parts.normalLabel, contact, normal, scale, "normal ");
  checkArrow(parts.friction, parts.frictionLabel, contact, rubbing, scale, "friction ");
  // The applied force is drawn 6 mm to the right of the ideal force, perpendicular to the arrow and
  // the line of sight.
  double third[3] = { force[0] / 3.0, force[1] / 3.0, force[2] / 3.0 };
  double ahead[3];
  double right[3];
  double from[3];
  scene->GetRenderer()->GetActiveCamera()->GetDirectionOfProjection(ahead);
  vtkMath::Cross(ahead, force, right);
  vtkMath::Normalize(right);
  for (int k = 0; k < 3; ++k)
  {
    from[k] = contact[k] + 6.0 * right[k];
  }
  checkArrow(parts.applied, parts.appliedLabel, from, third, scale, "applied ");
}

/// The circle has the contact radius of the tool, at the height at which the sphere leaves the
/// surface.
void checkCircle(vtkContactScene* scene, const double contact[3], double depth)
{
  const double a = makeTool("sphere:6.35")->GetContactRadius(depth);
  PALPATE_CHECK_NEAR(scene->GetContactRadius(), a, 1e-9);
  const double line = 0.08 + 0.05 * a; // half of the line's width
  const double up[3] = { 0.0, 0.0, 1.0 };
  const Extent circle = extentAlong(scene->GetCircleActor(), contact, up);
  const double height = -(depth - Radius + std::sqrt(Radius * Radius - a * a));
  PALPATE_CHECK(scene->GetCircleActor()->GetVisibility());
  PALPATE_CHECK_NEAR(circle.aside, a + line, Rounding);
  PALPATE_CHECK_NEAR(0.5 * (circle.low + circle.high), height, 1e-3); // normals are floats
  PALPATE_CHECK_NEAR(circle.high - circle.low, 2.0 * line, 1e-3);
}

/// The force along the trail is the force at the tips, and the legend uses the same unit. The trail
/// is dashed where the tool is deeper than the validity.
void checkTrail(vtkContactScene* scene, vtkPolyData* tips)
{
  vtkMapper* mapper = scene->GetTrailActor()->GetMapper();
  mapper->Update();
  auto* drawn = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  vtkDataArray* colored = drawn->GetPointData()->GetScalars();
  PALPATE_CHECK(
    scene->GetTrailActor()->GetVisibility() && scene->GetTrailLegend()->GetVisibility());
  PALPATE_CHECK(mapper->GetLookupTable() == scene->GetTrailLegend()->GetLookupTable());
  double* range = mapper->GetLookupTable()->GetRange();
  // 25 N is rounded up to the next of 10, 20, 30, 40, 60, 80
  PALPATE_CHECK(range[0] == 0.0 && range[1] == 30.0);
  vtkDataArray* force = tips->GetPointData()->GetArray("Force");
  vtkDataArray* deflection = tips->GetPointData()->GetArray("Deflection");
  std::vector<bool> covered(161, false); // one element per tenth of a millimetre
  for (vtkIdType i = 0; i < drawn->GetNumberOfPoints(); ++i)
  {
    double p[3];
    drawn->GetPoint(i, p);
    // Interpolates between tips, which are 0.4 mm apart.
    const double position = std::clamp((p[0] + 8.0) / 0.4, 0.0, 40.0);
    const auto left = std::min(static_cast<vtkIdType>(position), vtkIdType{ 39 });
    const double share = position - static_cast<double>(left);
    const double expected = (1.0 - share) * vtkMath::Norm(force->GetTuple3(left)) +
      share * vtkMath::Norm(force->GetTuple3(left + 1));
    PALPATE_CHECK_NEAR(colored->GetTuple1(i), expected, 0.01); // N; linear between tips
  }
  for (vtkIdType i = 0; i < drawn->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    drawn->GetCellBounds(i, bounds);
    for (std::size_t k = 0; k < covered.size(); ++k)
    {
      const double x = -8.0 + 0.1 * static_cast<double>(k);
      covered[k] = covered[k] || (bounds[0] <= x && x <= bounds[1]);
    }
  }
  int solid = 0;
  int dashed = 0;
  int gaps = 0;
  for (std::size_t k = 5; k < covered.size(); ++k)
  {
    // The tip at the end of this piece of the trail.
    const auto next = static_cast<vtkIdType>((k + 3) / 4);
    if (deflection->GetTuple1(next) <= ValidDepth)
    {
      PALPATE_CHECK(covered[k]);
      ++solid;
    }
    else
    {
      ++dashed;
      gaps += covered[k] ? 0 : 1;
    }
  }
  PALPATE_CHECK(solid > 15 && dashed > 100);
  PALPATE_CHECK_NEAR(gaps, 0.5 * dashed, 0.1 * dashed); // dashes and gaps have the same length
  PALPATE_CHECK_TEXT(scene->GetTrailLegend()->GetTitle(), "Force (N)\ndashed: beyond validity");
}

/// The arrow in the corner has the same length, in pixels, as an arrow of this force at the
/// contact, seen from the side.
void checkScale(vtkContactScene* scene, const double contact[3], double newtons)
{
  vtkRenderer* renderer = scene->GetRenderer();
  const double length = newtons * scene->GetToolRepresentation()->GetForceScale();
  double end[3];
  for (int k = 0; k < 3; ++k)
  {
    end[k] = contact[k] + (k == 0 ? length : 0.0); // the camera looks along y and z
  }
  double from[3] = { contact[0], contact[1], contact[2] };
  renderer->WorldToView(from[0], from[1], from[2]);
  renderer->WorldToView(end[0], end[1], end[2]);
  const double pixels = 0.5 * renderer->GetSize()[0] * (end[0] - from[0]);
  const ScaleParts parts(renderer);
  PALPATE_CHECK(std::string(parts.label->GetInput()) == std::to_string(int(newtons)) + " N");
  double bounds[6];
  vtkPolyData::SafeDownCast(parts.arrow->GetMapper()->GetInputDataObject(0, 0))->GetBounds(bounds);
  PALPATE_CHECK_NEAR(bounds[1] - bounds[0], pixels, 0.01);
}

/// The validity is the smallest validity of the corners of the contact triangle. The caption names
/// its limit.
void checkLimits(vtkContactScene* scene, vtkPolyData* body, vtkPolyData* tips, vtkIdType tip)
{
  const char* const names[] = { "(strain)", "(curvature of the body)", "(layer thickness)",
    "(the opposite wall)", "(an edge)", "(the measured data)" };
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(
    static_cast<vtkIdType>(tips->GetPointData()->GetArray("ContactCell")->GetTuple1(tip)), corners);
  for (int code = 1; code <= 6; ++code)
  {
    vtkNew<vtkPolyData> other;
    other->DeepCopy(body);
    const vtkIdType weakest = corners->GetId(code % 3);
    other->GetPointData()->GetArray("ResponseValidity")->SetTuple1(weakest, 0.125 * code);
    other->GetPointData()->GetArray("ResponseLimit")->SetTuple1(weakest, code);
    scene->SetBody(other);
    PALPATE_CHECK(scene->ShowTip(tips, tip));
    PALPATE_CHECK(scene->GetValidity() == 0.125 * code);
    PALPATE_CHECK_TEXT(caption(scene->GetRenderer()), names[code - 1]);
  }
  scene->SetBody(body);
}

/// If the response has an error array, the force has the error of the corner with the largest
/// error.
void checkError(vtkContactScene* scene, vtkPolyData* body, vtkPolyData* tips, vtkIdType tip)
{
  vtkNew<vtkPolyData> other;
  other->DeepCopy(body);
  vtkNew<vtkFloatArray> error;
  error->SetName("ResponseError");
  error->SetNumberOfComponents(
    body->GetPointData()->GetArray("ResponseForce")->GetNumberOfComponents());
  error->SetNumberOfTuples(body->GetNumberOfPoints());
  error->Fill(0.021);
  vtkNew<vtkIdList> corners;
  body->GetCellPoints(
    static_cast<vtkIdType>(tips->GetPointData()->GetArray("ContactCell")->GetTuple1(tip)), corners);
  for (int k = 0; k < error->GetNumberOfComponents(); ++k)
  {
    error->SetComponent(corners->GetId(1), k, 0.042);
  }
  other->GetPointData()->AddArray(error);
  scene->SetBody(other);
  PALPATE_CHECK(scene->ShowTip(tips, tip));
  PALPATE_CHECK_TEXT(caption(scene->GetRenderer()), " N \u00b1 3.");
  scene->SetBody(body);
}
} // namespace

int TestContactSceneForces(int argc, char* argv[])
{
  const Body body = withResponse(planeBody(30.0, 90), "sphere:6.35");
  const Body tips = slide(body);
  const vtkIdType last = tips->GetNumberOfPoints() - 1;

  Picture picture(640, 480);
  auto renderer = picture.addRenderer();
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(body);
  scene->SetTool(makeTool("sphere:6.35"));
  scene->SetPoissonRatio(0.0);
  scene->SetLargestForce(25.0); // 40 mm / 25 N = 1.6 mm/N, rounded down: 1; scale 10 N
  scene->SetLargestDeflection(1.5);
  PALPATE_CHECK(scene->ShowTip(tips, last) && scene->ShowTrail(tips));
  const double from[3] = { 0.0, -0.8, 0.5 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  scene->LookAtContact(95.0, from, up);
  const auto sound = draw(picture.window);

  double contact[3];
  tips->GetPointData()->GetArray("ContactPoint")->GetTuple(last, contact);
  checkForces(scene, tips, last);
  checkCircle(scene, contact, 1.5);
  checkTrail(scene, tips);
  checkScale(scene, contact, 10.0);
  // Stored as float; the radius is in double precision.
  PALPATE_CHECK_NEAR(scene->GetValidity(), ValidDepth, 1e-4);
  PALPATE_CHECK(!scene->IsValid());
  PALPATE_CHECK_TEXT(caption(renderer), "Deflection 1.50 mm, contact radius 2.9", "normal 20.",
    ", friction 8.", "\nApplied 7.", "beyond validity", "1.08 mm deep (strain)");
  checkBaseline(picture.window, argc, argv);

  checkError(scene, body, tips, last);
  checkLimits(scene, body, tips, last);
  scene->ShowTip(tips, last);
  checkSound(sound, picture.window);

  // The arrow is dashed: the shaft covers 3.2 of each 5 mm. Within validity it is solid.
  const ForceParts parts(scene->GetToolRepresentation());
  const double length = vtkMath::Norm(tips->GetPointData()->GetArray("Force")->GetTuple3(last));
  const double neck = length - 6.0;
  PALPATE_CHECK_NEAR(coveredBy(parts.total, neck), 3.2 * std::ceil(neck / 5.0),
    3.2); // the last dash may be cut
  PALPATE_CHECK(coveredBy(parts.total, neck) < 0.8 * neck);
  PALPATE_CHECK(scene->ShowTip(tips, 5)); // 0.75 mm deep
  PALPATE_CHECK(scene->IsValid() && caption(renderer).find("validity") == std::string::npos);
  const double force = vtkMath::Norm(tips->GetPointData()->GetArray("Force")->GetTuple3(5));
  PALPATE_CHECK_NEAR(coveredBy(parts.total, 0.6 * force), 0.6 * force, 1e-3);

  // Each part can be switched off, and then the picture differs.
  const auto without = [&](const char* what, const auto& set)
  {
    set(false);
    scene->ShowTip(tips, last);
    checkFaultShows(what, sound, picture.window);
    set(true);
    scene->ShowTip(tips, last);
    checkSound(sound, picture.window);
  };
  vtkHapticToolRepresentation* arrows = scene->GetToolRepresentation();
  without("no parts of the force", [&](bool on) { arrows->SetComponentsVisibility(on); });
  arrows->SetAppliedForceVisibility(false);
  scene->ShowTip(tips, last);
  PALPATE_CHECK(caption(renderer).find("Applied") == std::string::npos);
  arrows->SetAppliedForceVisibility(true);
  without("no applied force", [&](bool on) { arrows->SetAppliedForceVisibility(on); });
  without("no circle", [&](bool on) { scene->SetContactCircleVisibility(on); });
  without("no trail", [&](bool on) { scene->SetTrailVisibility(on); });
  scene->GetToolRepresentation()->SetBeyondValidity(false);
  scene->GetToolRepresentation()->SetContact(tips->GetPoint(last),
    tips->GetPointData()->GetArray("Normal")->GetTuple3(last), contact,
    tips->GetPointData()->GetArray("Force")->GetTuple3(last));
  checkFaultShows("solid arrow of the total alone", sound, picture.window);
  return palpate::testing::result();
}
