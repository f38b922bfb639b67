// SPDX-License-Identifier: BSD-3-Clause
// The live trail of a fast hand, and the scale of its forces. Even with few pictures, the line
// stays on the surface, is complete during the contact, and its gaps are explained. The scale
// follows the force.
#include "Picture.h"
#include "PlacedDevice.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkContactScene.h"
#include "vtkFrameClock.h"
#include "vtkLookupTable.h"
#include "vtkScalarBarActor.h"

namespace
{
using namespace palpate::testing;

constexpr double Radius = 40.0;     // mm; radius of the body
constexpr double TubeRadius = 0.5;  // mm; radius of the trail
constexpr double Coarseness = 0.02; // mm; largest distance of the body's facets below the sphere

/// A quarter of a great circle, 1 mm deep, in 0.4 s. In the middle it is `lifted` mm higher.
Body arc(double lifted)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(101);
  for (int i = 0; i <= 100; ++i)
  {
    const double angle = 0.5 * vtkMath::Pi() * (i / 100.0 - 0.5);
    const double high = i > 40 && i < 60 ? lifted : 0.0;
    const double r = Radius - 1.0 + high;
    line->InsertCellPoint(points->InsertNextPoint(r * std::sin(angle), 0.0, r * std::cos(angle)));
    time->InsertNextValue(0.1 + 0.004 * i);
  }
  auto path = Body::New();
  path->SetPoints(points);
  path->SetLines(line);
  path->GetPointData()->AddArray(time);
  return path;
}

/// A session along a path over the ball, which a scene shows five times a second.
struct Session
{
  vtkNew<vtkHapticSession> session;
  vtkNew<vtkFrameClock> clock;
  Picture picture{ 500, 400 };
  vtkSmartPointer<vtkRenderer> renderer = this->picture.addRenderer();
  vtkNew<vtkContactScene> scene;

  Session(vtkPolyData* body, vtkPolyData* path)
  {
    this->session->SetBody(body);
    this->session->GetDevice()->SetPath(path);
    this->scene->SetRenderer(this->renderer);
    this->scene->SetBody(body);
    this->scene->SetTool(makeTool("sphere:4"));
    this->scene->Follow(this->clock, this->session);
    PALPATE_CHECK(this->session->Start());
  }

  void play(double seconds)
  {
    for (int i = 0; i < std::lround(5.0 * seconds); ++i)
    {
      this->session->Step(0.2);
      this->scene->ShowSession(this->session);
    }
  }

  vtkPolyData* trail()
  {
    vtkMapper* mapper = this->scene->GetTrailActor()->GetMapper();
    mapper->Update();
    return vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  }
  std::string title() { return this->scene->GetTrailLegend()->GetTitle(); }
};

/// Returns the largest depth of the tube's outer side below the ball, mm.
double deepest(vtkPolyData* trail)
{
  double depth = -Radius;
  // The tube is visible if its outer side is above the ball: the highest of the twelve points of
  // each ring.
  for (vtkIdType i = 0; i + 12 <= trail->GetNumberOfPoints(); i += 12)
  {
    double highest = 0.0;
    for (vtkIdType k = 0; k < 12; ++k)
    {
      highest = std::max(highest, vtkMath::Norm(trail->GetPoint(i + k)));
    }
    depth = std::max(depth, Radius - highest);
  }
  return depth;
}

void checkFastDrag(vtkPolyData* body)
{
  Session fast(body, arc(0.0));
  fast.play(0.8);
  const double depth = deepest(fast.trail());
  // 63 mm of path in two pictures. A chord between them would be at least 3 mm below the surface.
  PALPATE_CHECK(fast.trail()->GetNumberOfPoints() > 12 * 30);
  // mm; tolerance for the tube's polygon and the chords of 1 mm
  PALPATE_CHECK(depth < -TubeRadius + 0.2);
  PALPATE_CHECK(fast.title().find("no contact") == std::string::npos);
}

void checkLift(vtkPolyData* body)
{
  Session lifting(body, arc(3.0));
  lifting.play(0.8);
  PALPATE_CHECK_TEXT(lifting.title(), "gap: no contact");
  vtkPolyData* trail = lifting.trail();
  for (vtkIdType i = 0; i < trail->GetNumberOfPoints(); ++i)
  {
    const double* p = trail->GetPoint(i);
    const double angle = std::atan2(p[0], p[2]);
    // The path is lifted at 40 < i < 60, which is -0.14 to 0.14 rad. The ramps extend to the
    // neighbours.
    PALPATE_CHECK(std::abs(angle) > 0.13);
  }
}

/// The scale grows immediately with the force, and a remark is shown for three seconds. The scale
/// shrinks again when the forces of the trail have been small for three seconds.
void checkScale(vtkPolyData* body)
{
  Session held(body, arc(0.0));
  double force[3];
  held.play(1.0); // the hand stays at the end of its path
  held.session->GetIdealForce(force);
  const double newtons = vtkMath::Norm(force);
  const auto end = [&held]
  { return held.scene->GetTrailLegend()->GetLookupTable()->GetRange()[1]; };
  const auto remark = [&held]
  {
    held.picture.window->Render();
    return std::string(ScaleParts(held.renderer).label->GetInput());
  };
  held.scene->SetLargestForce(0.4 * newtons);
  held.play(0.2);
  PALPATE_CHECK(end() >= newtons && end() < 2.0 * newtons);
  // The force varies at edges.
  PALPATE_CHECK_NEAR(held.scene->GetLargestForce(), newtons, 0.05 * newtons);
  PALPATE_CHECK_TEXT(remark(), "scale changed");
  held.play(3.2);
  PALPATE_CHECK(remark().find("changed") == std::string::npos);

  held.scene->SetLargestForce(20.0 * newtons);
  held.play(2.8);
  PALPATE_CHECK(end() >= 20.0 * newtons); // the scale must not have shrunk yet
  held.play(0.6);
  PALPATE_CHECK(end() >= newtons && end() < 2.0 * newtons);
  PALPATE_CHECK_TEXT(remark(), "scale changed");

  // A scale that fits is not changed.
  held.scene->SetLargestForce(2.0 * newtons);
  held.play(6.0);
  PALPATE_CHECK(held.scene->GetLargestForce() == 2.0 * newtons);
}
} // namespace

int TestContactSceneTrail(int, char*[])
{
  const Body body = withResponse(sphereBody(Radius, 6), "sphere:4");
  checkFastDrag(body);
  checkLift(body);
  checkScale(body);
  return palpate::testing::result();
}
