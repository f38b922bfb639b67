// SPDX-License-Identifier: BSD-3-Clause
// The labels of a tool, from many directions. Each label is inside the viewport and covers neither
// the tool, an arrow, the contact circle nor another label. An arrow seen end-on has a ring. A
// steady label does not jump.
#include "Picture.h"
#include "Response/TestBodies.h"
#include "SceneBodies.h"
#include "SceneParts.h"

#include "vtkCamera.h"
#include "vtkContactScene.h"
#include "vtkPolyDataMapper2D.h"

#include <array>
#include <vector>

namespace
{
using namespace palpate::testing;

constexpr double Tip[3] = { 0.0, 0.0, -1.0 };
constexpr double Contact[3] = { 0.0, 0.0, 0.0 };
constexpr double Up[3] = { 0.0, 0.0, 1.0 };
constexpr double CircleRadius = 4.0; // mm

using Point = std::array<double, 2>; // pixels

/// A box in the window, pixels.
struct Box
{
  Point low;
  Point high;

  bool has(const Point& point) const
  {
    return this->low[0] < point[0] && point[0] < this->high[0] && this->low[1] < point[1] &&
      point[1] < this->high[1];
  }
};

Point inPicture(vtkRenderer* renderer, double x, double y, double z)
{
  renderer->WorldToView(x, y, z);
  return { 0.5 * renderer->GetSize()[0] * (1.0 + x), 0.5 * renderer->GetSize()[1] * (1.0 + y) };
}

Box boxOf(vtkRenderer* renderer, vtkTextActor* label)
{
  const double* place = label->GetPositionCoordinate()->GetValue();
  const Point low = inPicture(renderer, place[0], place[1], place[2]);
  double size[2];
  label->GetSize(renderer, size);
  return { low, { low[0] + size[0], low[1] + size[1] } };
}

/// Returns the drawn points of an actor, and three points between them on each edge of its
/// triangles.
std::vector<Point> pointsOf(vtkRenderer* renderer, vtkActor* actor)
{
  actor->GetMapper()->Update();
  auto* drawn = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  std::vector<Point> points;
  const auto add = [&](const double* local)
  {
    double p[4] = { local[0], local[1], local[2], 1.0 };
    actor->GetMatrix()->MultiplyPoint(p, p);
    points.push_back(inPicture(renderer, p[0], p[1], p[2]));
  };
  for (vtkIdType i = 0; i < drawn->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = drawn->GetCell(i);
    const vtkIdType count = cell->GetNumberOfPoints();
    for (vtkIdType k = 0; k < count; ++k)
    {
      double a[3];
      double b[3];
      drawn->GetPoint(cell->GetPointId(k), a);
      drawn->GetPoint(cell->GetPointId((k + 1) % count), b);
      for (int step = 0; step < 4; ++step)
      {
        const double share = step / 4.0;
        const double between[3] = { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
          a[2] + share * (b[2] - a[2]) };
        add(between);
      }
    }
  }
  return points;
}

int countIn(const Box& box, const std::vector<Point>& points)
{
  return static_cast<int>(
    std::count_if(points.begin(), points.end(), [&](const Point& p) { return box.has(p); }));
}

std::vector<Point> circlePoints(vtkRenderer* renderer)
{
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / 100;
    points.push_back(
      inPicture(renderer, CircleRadius * std::cos(angle), CircleRadius * std::sin(angle), 0.0));
  }
  return points;
}

void look(vtkRenderer* renderer, double azimuth, double height, double distance)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double across = std::cos(height) * distance;
  camera->SetFocalPoint(0.0, 0.0, 10.0);
  camera->SetPosition(
    across * std::cos(azimuth), across * std::sin(azimuth), 10.0 + std::sin(height) * distance);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}

/// Checks all labels in the present picture. Returns the number of visible labels.
int checkLabels(vtkRenderer* renderer, vtkHapticToolRepresentation* shown)
{
  const ForceParts parts(shown);
  const std::vector<Point> tool = pointsOf(renderer, ToolParts(shown).tool);
  const std::vector<Point> circle = circlePoints(renderer);
  std::vector<Box> boxes;
  for (vtkTextActor* label :
    { parts.totalLabel, parts.normalLabel, parts.frictionLabel, parts.appliedLabel })
  {
    if (!label->GetVisibility())
    {
      continue;
    }
    const Box box = boxOf(renderer, label);
    PALPATE_CHECK(box.low[0] >= 0.0 && box.low[1] >= 0.0);
    PALPATE_CHECK(box.high[0] <= renderer->GetSize()[0] && box.high[1] <= renderer->GetSize()[1]);
    PALPATE_CHECK(countIn(box, tool) == 0);
    PALPATE_CHECK(countIn(box, circle) == 0);
    for (vtkActor* arrow : { parts.total, parts.normal, parts.friction, parts.applied })
    {
      PALPATE_CHECK(!arrow->GetVisibility() || countIn(box, pointsOf(renderer, arrow)) == 0);
    }
    for (const Box& other : boxes)
    {
      PALPATE_CHECK(box.high[0] <= other.low[0] || other.high[0] <= box.low[0] ||
        box.high[1] <= other.low[1] || other.high[1] <= box.low[1]);
    }
    boxes.push_back(box);
  }
  return static_cast<int>(boxes.size());
}

/// Returns the visible ring of an arrow: a part in the overlay that is not text.
vtkPolyData* ringOf(vtkHapticToolRepresentation* shown)
{
  vtkPropCollection* parts = shown->GetParts();
  for (int i = 0; i < parts->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor2D::SafeDownCast(parts->GetItemAsObject(i));
    if (actor && !vtkTextActor::SafeDownCast(actor) && actor->GetVisibility())
    {
      return vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    }
  }
  return nullptr;
}

/// From the front, the total force has no ring. From above it has a ring with a dot, as wide as the
/// arrow is long. From below it has a ring with a cross.
void checkRing(vtkRenderer* renderer, vtkRenderWindow* window, vtkHapticToolRepresentation* shown)
{
  const double force[3] = { 0.0, 0.0, 2.0 };
  shown->SetContact(Tip, Up, Contact, force); // length 20 mm
  look(renderer, 0.3, 0.0, 120.0);
  window->Render();
  PALPATE_CHECK(!ringOf(shown));
  for (const double side : { 1.0, -1.0 })
  {
    look(renderer, 0.3, side * 0.49 * vtkMath::Pi(), 120.0);
    window->Render();
    vtkPolyData* ring = ringOf(shown);
    PALPATE_CHECK(ring);
    if (!ring)
    {
      continue;
    }
    double bounds[6];
    ring->GetBounds(bounds);
    // An arrow of 20 mm is in the plane of the picture at the head, 10 mm above the focus. The
    // angle of view is 30 degrees.
    const double distance = 120.0 - side * 10.0;
    const double pixels =
      20.0 * 0.5 * renderer->GetSize()[1] / (std::tan(vtkMath::Pi() / 12.0) * distance);
    // The head is not exactly in the middle of the view.
    PALPATE_CHECK_NEAR(bounds[1] - bounds[0], pixels, 0.01 * pixels);
    PALPATE_CHECK(ring->GetNumberOfPolys() == (side > 0.0 ? 1 : 0)); // the dot
    PALPATE_CHECK(ring->GetNumberOfLines() == (side > 0.0 ? 1 : 3)); // the cross
  }
  // A force of a hundredth still has a visible ring.
  const double small[3] = { 0.0, 0.0, 0.02 };
  shown->SetContact(Tip, Up, Contact, small);
  window->Render();
  PALPATE_CHECK(ringOf(shown) && ringOf(shown)->GetLength() > 16.0);
}

/// Sum of the motions of the label relative to the arrow's head while the camera turns, pixels.
double wandering(
  vtkRenderer* renderer, vtkRenderWindow* window, vtkHapticToolRepresentation* shown, bool steady)
{
  const double force[3] = { 0.6, 0.0, 2.0 };
  shown->SetSteadyLabels(steady);
  shown->SetContact(Tip, Up, Contact, force);
  double sum = 0.0;
  Point last{};
  for (int i = 0; i <= 120; ++i)
  {
    look(renderer, 0.05 * i, 0.5, 120.0);
    window->Render();
    const Point place = boxOf(renderer, ToolParts(shown).label).low;
    const Point head = inPicture(renderer, 6.0, 0.0, 20.0);
    const Point now{ place[0] - head[0], place[1] - head[1] };
    sum += i > 0 ? std::hypot(now[0] - last[0], now[1] - last[1]) : 0.0;
    last = now;
  }
  shown->SetSteadyLabels(false);
  return sum;
}

/// In a scene, the label leaves the trail free, wherever the tool came from.
void checkTrail()
{
  Picture picture(640, 480);
  auto renderer = picture.addRenderer();
  const Body body = withResponse(planeBody(40.0, 20), "sphere:3");
  vtkNew<vtkContactScene> scene;
  scene->SetRenderer(renderer);
  scene->SetBody(body);
  scene->SetTool(makeTool("sphere:3"));
  scene->SetLargestForce(20.0);
  constexpr double depth = 0.8;
  for (int turn = 0; turn < 8; ++turn)
  {
    const double angle = 2.0 * vtkMath::Pi() * turn / 8;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 60; i >= 0; --i) // 30 mm towards the middle, in a bow
    {
      const double bent = angle + 0.01 * i;
      points->InsertNextPoint(0.5 * i * std::cos(bent), 0.5 * i * std::sin(bent), -depth);
    }
    const Body tips = Body::New();
    tips->SetPoints(points);
    const Body way = probed(body, tips);
    PALPATE_CHECK(scene->ShowTrail(way));
    PALPATE_CHECK(scene->ShowTip(way, way->GetNumberOfPoints() - 1));
    look(renderer, 0.3, 1.2, 110.0);
    picture.window->Render();
    const Box box = boxOf(renderer, ToolParts(scene->GetToolRepresentation()).label);
    PALPATE_CHECK(countIn(box, pointsOf(renderer, scene->GetTrailActor())) == 0);
  }
}
} // namespace

int TestForceLabels(int, char*[])
{
  Picture picture(640, 480);
  auto renderer = picture.addRenderer();
  vtkNew<vtkHapticToolRepresentation> shown;
  shown->SetTool(makeTool("sphere:6"));
  shown->SetContactRadius(CircleRadius);
  renderer->AddViewProp(shown);

  const double forces[][3] = { { 0.0, 0.0, 2.0 }, { 1.5, 0.3, 1.5 }, { -1.0, 1.0, 0.4 } };
  const double friction[3] = { -0.6, 0.2, 0.0 };
  const double none[3] = { 0.0, 0.0, 0.0 };
  int most = 0;
  for (const auto& force : forces)
  {
    const double half[3] = { 0.5 * force[0], 0.5 * force[1], 0.5 * force[2] };
    for (const double* rubbing : { none, friction })
    {
      shown->SetContact(Tip, Up, Contact, force, rubbing, rubbing == none ? force : half);
      for (int i = 0; i < 12; ++i)
      {
        look(renderer, 0.9 * i, -1.2 + 0.2 * i, i % 2 ? 140.0 : 90.0);
        picture.window->Render();
        most = std::max(most, checkLabels(renderer, shown));
      }
    }
  }
  PALPATE_CHECK(most == 4);

  // In the close-up the head of the arrow is at the upper edge, and the tool fills a third of the
  // picture.
  shown->SetContact(Tip, Up, Contact, forces[0]);
  for (const double distance : { 60.0, 45.0 })
  {
    look(renderer, 0.4, 0.1, distance);
    picture.window->Render();
    checkLabels(renderer, shown);
  }

  checkTrail();
  checkRing(renderer, picture.window, shown);
  const double steady = wandering(renderer, picture.window, shown, true);
  const double restless = wandering(renderer, picture.window, shown, false);
  PALPATE_CHECK(steady < 0.7 * restless); // otherwise the places are not kept
  return palpate::testing::result();
}
