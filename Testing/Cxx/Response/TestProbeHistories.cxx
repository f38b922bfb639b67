// SPDX-License-Identifier: BSD-3-Clause
// Tips in the probe: histories on polylines, single tips, Indentation, borders, cells of a mixed
// body, the copy of the body that is kept between updates, threads.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkIdTypeArray.h"
#include "vtkToolContactProbe.h"
#include "Mechanics/Numerics/Constants.h"

#include <vector>

namespace
{
using namespace palpate::testing;
using palpate::NotANumber;

constexpr double Young = 3.45; // E of withResponse, MPa

using Points = std::vector<std::array<double, 3>>;

Body makeTips(const Points& positions)
{
  auto tips = Body::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  tips->SetPoints(points);
  tips->SetLines(vtkNew<vtkCellArray>());
  return tips;
}

void addLine(vtkPolyData* tips, const std::vector<vtkIdType>& ids)
{
  tips->GetLines()->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  tips->Modified();
}

/// A probe and one number of its output.
struct Probe
{
  vtkNew<vtkToolContactProbe> filter;
  Probe(vtkPolyData* body, vtkPolyData* tips)
  {
    this->filter->SetInputData(body);
    this->filter->SetTipData(tips);
    this->filter->SetForceFormToNormalizedDirection();
    this->filter->SetContactSurfaceToFacets();
  }
  double get(const char* name, vtkIdType tip, int component = 0)
  {
    this->filter->Update();
    return this->filter->GetOutput()->GetPointData()->GetArray(name)->GetComponent(tip, component);
  }
};

/// A slab of thickness 1 mm from z = -0.5 to 0.5. Tips enter it from above at x = 0.3, y = 0.2.
Body slab()
{
  return withResponse(boxBody(10.0, 10.0, 0.5, 8), "flat:1");
}

/// In a history the contact stays on the side of entry, even beyond the other face. For a single
/// tip the nearer side counts.
void checkSlab()
{
  const Body body = slab();
  const std::vector<double> heights = { 0.6, 0.3, 0.05, -0.2, -0.4, -0.7, -0.2, 0.3, 0.6 };
  Points positions;
  std::vector<vtkIdType> ids;
  for (const double z : heights)
  {
    ids.push_back(static_cast<vtkIdType>(positions.size()));
    positions.push_back({ 0.3, 0.2, z });
  }
  const auto tips = makeTips(positions);
  Probe single(body, tips);
  const auto followed = makeTips(positions);
  addLine(followed, ids);
  Probe history(body, followed);
  for (const vtkIdType i : ids)
  {
    const double z = heights[static_cast<std::size_t>(i)];
    // The law of the punch, F = 2 a E* δ, is stored exactly except for the float rounding of 6e-8.
    const double deep = std::max(0.0, 0.5 - z);
    PALPATE_CHECK_NEAR(history.get("Deflection", i), deep, 1e-14);
    PALPATE_CHECK_NEAR(history.get("Force", i, 2), 2.0 * Young * deep, 2e-6);
    PALPATE_CHECK(history.get("ContactState", i) == (deep > 0.0 ? 2.0 : 0.0));
    const double shallow = std::max(0.0, 0.5 - std::abs(z));
    PALPATE_CHECK_NEAR(single.get("Deflection", i), shallow, 1e-14);
    PALPATE_CHECK_NEAR(single.get("Force", i, 2), (z > 0.0 ? 2.0 : -2.0) * Young * shallow, 2e-6);
  }
}

/// The tips of a line are evaluated in the order of the line, separately for each line. Points
/// outside lines are single tips. A tip that is not finite ends the history.
void checkLines()
{
  const Body body = slab();
  const auto tips =
    makeTips({ { 0.3, 0.2, -0.4 }, { 0.3, 0.2, 0.4 }, { 0.3, 0.2, -0.4 }, { NotANumber, 0.2, 0.0 },
      { 0.3, 0.2, -0.4 }, { 1.3, 0.2, 0.4 }, { 1.3, 0.2, -0.4 }, { 0.3, 0.2, -0.4 } });
  addLine(tips, { 1, 0 });       // downward, in the opposite order of the points
  addLine(tips, { 2 });          // begins below the middle of the slab
  addLine(tips, { 5, 6, 3, 4 }); // interrupted by a tip that is not finite
  Probe probe(body, tips);
  const double depth[] = { 0.9, 0.1, 0.1, 0.0, 0.1, 0.1, 0.9, 0.1 };
  for (vtkIdType i = 0; i < 8; ++i)
  {
    PALPATE_CHECK_NEAR(probe.get("Deflection", i), depth[i], 1e-14);
    PALPATE_CHECK(probe.get("ContactState", i) == (i == 3 ? 5.0 : 2.0));
  }
  PALPATE_CHECK(probe.get("Force", 0, 2) > 0.0 && probe.get("Force", 2, 2) < 0.0);
  PALPATE_CHECK(probe.get("ContactCell", 3) == -1.0 && probe.get("Force", 3, 0) == 0.0);

  Messages messages(probe.filter);
  addLine(tips, { 0, 8 });
  probe.filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "polyline 3", "point 8", "8 points");
  PALPATE_CHECK(probe.filter->GetOutput()->GetNumberOfPoints() == 0);
}

void checkBorderAndRange()
{
  const Body body = withResponse(planeBody(5.0, 4), "flat:1", 1.0);
  Probe probe(body,
    makeTips({ { 0.1, 0.2, -0.5 }, { 0.1, 0.2, -1.5 }, { 9.0, 0.0, -0.5 }, { 9.0, 0.0, 0.5 },
      { 0.1, 0.2, 0.5 }, { 9.0, 9.0, -0.5 } }));
  const double state[] = { 2.0, 3.0, 4.0, 0.0, 0.0, 4.0 };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    PALPATE_CHECK(probe.get("ContactState", i) == state[i]);
    const bool contact = i < 2;
    PALPATE_CHECK((probe.get("ContactCell", i) >= 0.0) == contact);
    PALPATE_CHECK((probe.get("NormalForce", i) > 0.0) == contact);
  }
  // Beyond the range the curve continues as its last tangent, which for a punch is the law itself.
  PALPATE_CHECK_NEAR(probe.get("NormalForce", 1), 2.0 * Young * 1.5, 2e-6);
}

/// ContactCell is the cell number in the body, whose verts and lines come before its triangles.
void checkCellIds()
{
  Body body = planeBody(5.0, 4);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  verts->InsertNextCell({ 1 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  body->SetVerts(verts);
  body->SetLines(lines);
  // points near the middle corner of each triangle, thus in the triangle's half of the square
  Points inside;
  for (vtkIdType cell = 3; cell < body->GetNumberOfCells(); ++cell)
  {
    const bool lower = cell % 2 == 1;
    const double* corner =
      body->GetPoint(body->GetCell(cell)->GetPointId(0)); // corner of the square
    inside.push_back({ corner[0] + (lower ? 2.0 : 0.5), corner[1] + (lower ? 0.5 : 2.0), -0.1 });
  }
  const Body made = withResponse(body, "flat:1");
  Probe probe(made, makeTips(inside));
  for (vtkIdType cell = 3; cell < made->GetNumberOfCells(); ++cell)
  {
    PALPATE_CHECK(made->GetCellType(cell) == VTK_TRIANGLE);
    PALPATE_CHECK(probe.get("ContactCell", cell - 3) == static_cast<double>(cell));
  }
}

/// A point on the surface has a force after it is moved inward by Indentation.
void checkIndentation()
{
  const Body plane = withResponse(planeBody(5.0, 4), "flat:1");
  Probe flat(plane, makeTips({ { 0.3, 0.1, 0.0 }, { 0.3, 0.1, 0.25 } }));
  PALPATE_CHECK(flat.get("ContactState", 0) == 0.0);
  flat.filter->SetIndentation(0.5);
  PALPATE_CHECK_NEAR(flat.get("Deflection", 0), 0.5, 1e-15);
  PALPATE_CHECK_NEAR(flat.get("Deflection", 1), 0.25, 1e-15);
  Messages messages(flat.filter);
  flat.filter->SetIndentation(NotANumber);
  flat.filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "Indentation", "nan");

  // On a ball of 20 mm with facets of 5 mm the tip moves along the blended normal, not along that
  // of the facet. The depth therefore differs from the requested depth by at most the sagitta of a
  // facet, h²/8R = 0.15 mm.
  Body ball = sphereBody(20.0, 2);
  const Body body = withResponse(ball, "sphere:5");
  double onFacet[3] = { 0.0, 0.0, 0.0 };
  vtkNew<vtkIdList> corners;
  ball->GetCellPoints(17, corners);
  for (vtkIdType k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      onFacet[c] += ball->GetPoint(corners->GetId(k))[c] / 3.0;
    }
  }
  Probe round(body, makeTips({ { onFacet[0], onFacet[1], onFacet[2] } }));
  round.filter->SetIndentation(1.0);
  PALPATE_CHECK_NEAR(round.get("Deflection", 0), 1.0, 1e-3);
  PALPATE_CHECK(round.get("ContactCell", 0) == 17.0);
}

/// The probe keeps its copy of the body and detects every kind of change.
void checkCache()
{
  Body body = Body::New();
  body->DeepCopy(withResponse(planeBody(5.0, 4), "flat:1"));
  Probe probe(body, makeTips({ { 0.3, 0.1, -0.5 } }));
  const double first = probe.get("NormalForce", 0);
  for (const char* name : { "ResponseForce", "ResponseStiffness" })
  {
    auto* array = vtkFloatArray::SafeDownCast(body->GetPointData()->GetArray(name));
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      array->SetValue(i, 3.0F * array->GetValue(i));
    }
    array->Modified();
  }
  PALPATE_CHECK_NEAR(probe.get("NormalForce", 0), 3.0 * first, 1e-6 * first); // float rounding
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    body->GetPoints()->SetPoint(i, x[0], x[1], 0.5);
  }
  body->GetPoints()->Modified();
  PALPATE_CHECK_NEAR(probe.get("Deflection", 0), 1.0, 1e-15);
  Messages messages(probe.filter);
  probe.filter->SetResponseName("Other");
  probe.filter->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "no response 'Other'");
  probe.filter->SetResponseName("Response");
  PALPATE_CHECK_NEAR(probe.get("Deflection", 0), 1.0, 1e-15);
}
} // namespace

int TestProbeHistories(int, char*[])
{
  checkSlab();
  checkLines();
  checkBorderAndRange();
  checkCellIds();
  checkIndentation();
  checkCache();
  return palpate::testing::result();
}
