// SPDX-License-Identifier: BSD-3-Clause
// Single tips on a body that is not convex, against brute force: the closest of all triangles and
// the winding number of BruteForce.h, and the force by the definition of the contract.
#include "BruteForce.h"
#include "ContractOracle.h"
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkToolContactProbe.h"
#include "vtkTriangle.h"

#include <array>

namespace
{
using namespace palpate::testing;
using palpate::Vector3;

constexpr double Range = 1.5;

/// A sphere of 10 mm with bumps of 1 mm and another modulus at each point.
Body bumpyBody()
{
  Body body = sphereBody(10.0, 3);
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    double x[3];
    body->GetPoint(i, x);
    vtkMath::MultiplyScalar(
      x, 1.0 + 0.1 * std::sin(0.7 * x[0]) * std::cos(0.9 * x[1] + 0.4 * x[2]));
    body->GetPoints()->SetPoint(i, x);
  }
  snapPoints(body);
  pointArray(body, "E", [](vtkIdType i) { return 0.1 + 0.001 * static_cast<double>(i); });
  vtkNew<vtkToolContactResponse> filter;
  filter->SetInputData(body);
  filter->SetTool(makeTool("sphere:2"));
  filter->SetMaximumDeflection(Range);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
  filter->Update();
  Body output = Body::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

/// The points and triangles of a body for the brute-force search.
Surface surfaceOf(vtkPolyData* body)
{
  Surface surface;
  for (vtkIdType point = 0; point < body->GetNumberOfPoints(); ++point)
  {
    const double* x = body->GetPoint(point);
    surface.points.emplace_back(x[0], x[1], x[2]);
  }
  for (vtkIdType cell = 0; cell < body->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    body->GetCellPoints(cell, count, corners);
    surface.triangles.push_back({ static_cast<std::int32_t>(corners[0]),
      static_cast<std::int32_t>(corners[1]), static_cast<std::int32_t>(corners[2]) });
  }
  return surface;
}

/// Σ n_i f_i along the normalised Σ n_i U_i, with area coordinates computed from areas.
std::array<double, 3> blendedForce(vtkPolyData* body, const Nearest& contact)
{
  vtkCell* triangle = body->GetCell(contact.triangle);
  double p[3][3];
  for (int k = 0; k < 3; ++k)
  {
    triangle->GetPoints()->GetPoint(k, p[k]);
  }
  const double whole = vtkTriangle::TriangleArea(p[0], p[1], p[2]);
  const double foot[3] = { static_cast<double>(contact.point.x()),
    static_cast<double>(contact.point.y()), static_cast<double>(contact.point.z()) };
  const ContractOracle oracle(body);
  double force = 0.0;
  std::array<double, 3> direction{};
  for (int k = 0; k < 3; ++k)
  {
    const double weight = vtkTriangle::TriangleArea(foot, p[(k + 1) % 3], p[(k + 2) % 3]) / whole;
    force += weight * oracle.force(triangle->GetPointId(k), static_cast<double>(contact.distance));
    double n[3];
    oracle.normal(triangle->GetPointId(k), n);
    for (std::size_t c = 0; c < 3; ++c)
    {
      direction[c] += weight * n[c];
    }
  }
  vtkMath::Normalize(direction.data());
  return { force * direction[0], force * direction[1], force * direction[2] };
}

void checkBruteForce(vtkPolyData* body, vtkPolyData* tips, vtkPolyData* output)
{
  vtkPointData* data = output->GetPointData();
  const Surface surface = surfaceOf(body);
  const std::vector<std::int32_t> all = allTriangles(surface);
  // Coordinates of about 10 mm and forces of about 1 N have a rounding of about 1e-15 in each of a
  // few dozen steps. The area coordinates of the reference lose half of their digits by
  // cancellation: 1e-8 of a facet.
  constexpr double Length = 1e-11;
  constexpr double Force = 1e-7;
  std::array<int, 6> states{};
  for (vtkIdType i = 0; i < tips->GetNumberOfPoints(); ++i)
  {
    const Vector3 tip(tips->GetPoint(i));
    const Nearest expected = nearestOf(surface, tip, all);
    const auto depth = static_cast<double>(expected.distance);
    const auto state = static_cast<int>(data->GetArray("ContactState")->GetTuple1(i));
    ++states.at(static_cast<std::size_t>(state));
    double found[3];
    if (windingNumber(surface, tip) < 0.5)
    {
      PALPATE_CHECK(state == 0 && data->GetArray("ContactCell")->GetTuple1(i) == -1.0);
      for (const char* name : { "Force", "Normal", "ContactPoint", "FrictionForce" })
      {
        data->GetArray(name)->GetTuple(i, found);
        PALPATE_CHECK(found[0] == 0.0 && found[1] == 0.0 && found[2] == 0.0);
      }
      PALPATE_CHECK(data->GetArray("Deflection")->GetTuple1(i) == 0.0);
      PALPATE_CHECK(data->GetArray("NormalForce")->GetTuple1(i) == 0.0);
      continue;
    }
    PALPATE_CHECK(state == (depth > static_cast<double>(static_cast<float>(Range)) ? 3 : 2));
    PALPATE_CHECK_NEAR(data->GetArray("Deflection")->GetTuple1(i), depth, Length);
    data->GetArray("ContactPoint")->GetTuple(i, found);
    const auto force = blendedForce(body, expected);
    double actual[3];
    data->GetArray("Force")->GetTuple(i, actual);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto place = static_cast<double>(expected.point[static_cast<Eigen::Index>(c)]);
      PALPATE_CHECK_NEAR(found[c], place, 1e-7); // at a flat minimum: square root of Length
      PALPATE_CHECK_NEAR(actual[c], force[c], Force);
    }
    const double normalForce = data->GetArray("NormalForce")->GetTuple1(i);
    PALPATE_CHECK_NEAR(vtkMath::Norm(actual), normalForce, 1e-14 * normalForce);
    data->GetArray("Normal")->GetTuple(i, found);
    PALPATE_CHECK_NEAR(vtkMath::Dot(actual, found), normalForce, 1e-14 * normalForce);
    // Two triangles may be equally near at an edge. The returned cell must be at the same distance.
    const auto cell = static_cast<std::int32_t>(data->GetArray("ContactCell")->GetTuple1(i));
    const Nearest there = nearestOf(surface, tip, { cell });
    PALPATE_CHECK_NEAR(static_cast<double>(there.distance), depth, Length);
  }
  PALPATE_CHECK(states[0] > 50 && states[2] > 50 && states[3] > 50); // all cases occur
}

void checkArrays(vtkPolyData* tips, vtkPolyData* output)
{
  PALPATE_CHECK(output->GetPoints() == tips->GetPoints());
  PALPATE_CHECK(
    output->GetPointData()->GetArray("Label") == tips->GetPointData()->GetArray("Label"));
  const std::map<std::string, std::pair<int, int>> expected = { { "Force", { VTK_DOUBLE, 3 } },
    { "NormalForce", { VTK_DOUBLE, 1 } }, { "FrictionForce", { VTK_DOUBLE, 3 } },
    { "Deflection", { VTK_DOUBLE, 1 } }, { "Normal", { VTK_DOUBLE, 3 } },
    { "ContactPoint", { VTK_DOUBLE, 3 } }, { "ContactCell", { VTK_ID_TYPE, 1 } },
    { "ContactState", { VTK_UNSIGNED_CHAR, 1 } } };
  for (const auto& [name, shape] : expected)
  {
    vtkDataArray* array = output->GetPointData()->GetArray(name.c_str());
    PALPATE_CHECK(array && array->GetDataType() == shape.first &&
      array->GetNumberOfComponents() == shape.second &&
      array->GetNumberOfTuples() == tips->GetNumberOfPoints());
  }
}
} // namespace

int TestToolContactProbe(int, char*[])
{
  const Body body = bumpyBody();
  const Body tips = tipsInCube(1500, 11.0, 20240611);
  pointArray<vtkIntArray>(tips, "Label", [](vtkIdType i) { return 2.0 * static_cast<double>(i); });
  vtkNew<vtkToolContactProbe> probe;
  Messages messages(probe);
  probe->SetInputData(body);
  probe->SetTipData(tips);
  probe->SetForceFormToNormalizedDirection();
  probe->SetContactSurfaceToFacets();
  probe->Update();
  PALPATE_CHECK(messages.none());
  checkArrays(tips, probe->GetOutput());
  checkBruteForce(body, tips, probe->GetOutput());
  return palpate::testing::result();
}
