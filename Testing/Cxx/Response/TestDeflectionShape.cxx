// SPDX-License-Identifier: BSD-3-Clause
// The displacement field on a body of true shape, against finite elements under the same force on a
// patch (vtkElasticCompliance, without any subtraction): near an edge, over a nodule, on a layer,
// on a column that bends. Also the messages on invalid arrays, and the field without these arrays.
#include "FilterChecks.h"
#include "NoduleBodies.h"
#include "ProbedTips.h"

#include "vtkElasticCompliance.h"
#include "vtkElasticContactResponse.h"
#include "vtkFieldData.h"
#include "vtkToolContactProbe.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
using namespace palpate::testing;
using Vector3 = Eigen::Vector3d;

constexpr double Nu = 0.45;

/// A press at a point of the surface of a grid.
struct Press
{
  Grid grid;
  Vector3 place;
  Vector3 normal;
  std::string tool;
  double depth;
};

/// The displacement field of a press, and the field of finite elements.
struct Drawn
{
  Body body;
  Body tips;
  vtkSmartPointer<vtkFloatArray> field;
  vtkSmartPointer<vtkDataArray> truth;
};

vtkSmartPointer<vtkContactDeflection> deflection(
  const Press& press, vtkPolyData* body, vtkPolyData* tips)
{
  auto filter = makeFilter(body, tips, makeTool(press.tool));
  filter->SetPoissonRatio(Nu);
  return filter;
}

Drawn draw(const Press& press)
{
  vtkNew<vtkElasticContactResponse> response;
  response->SetInputData(press.grid);
  response->SetTool(makeTool(press.tool));
  response->SetYoungsModulus(1.0);
  response->SetPoissonRatio(Nu);
  response->SetMaximumDeflection(press.depth);
  response->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "E");
  Messages messages(response.Get());
  response->Update();
  PALPATE_CHECK(messages.errors().empty());
  Drawn drawn;
  drawn.body = response->GetOutput();
  const vtkIdType point =
    drawn.body->vtkDataSet::FindPoint(press.place[0], press.place[1], press.place[2]);
  const Vector3 tip = press.place - 0.999 * press.depth * press.normal;
  vtkNew<vtkToolContactProbe> probe;
  probe->SetInputData(drawn.body);
  vtkNew<vtkPolyData> tips;
  vtkNew<vtkPoints> place;
  place->SetDataType(VTK_DOUBLE);
  place->InsertNextPoint(tip.data());
  tips->SetPoints(place);
  probe->SetTipData(tips);
  probe->Update();
  drawn.tips = probe->GetOutput();
  const auto field = deflection(press, drawn.body, drawn.tips);
  field->Update();
  drawn.field = vtkFloatArray::SafeDownCast(
    field->GetOutput()->GetPointData()->GetArray("ContactDisplacement"));
  vtkNew<vtkElasticCompliance> elements;
  elements->SetInputData(press.grid);
  elements->SetYoungsModulus(1.0);
  elements->SetPoissonRatio(Nu);
  elements->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "E");
  elements->SetNumberOfModes(0);
  elements->SetLoadedPoint(point);
  elements->SetLoadForce(drawn.tips->GetPointData()->GetArray("NormalForce")->GetTuple1(0));
  elements->Update();
  drawn.truth = elements->GetOutput()->GetPointData()->GetArray("LoadedDisplacement");
  PALPATE_CHECK(drawn.truth->GetNumberOfTuples() == drawn.body->GetNumberOfPoints());
  return drawn;
}

/// Root mean square error of the field along the normal, divided by the deflection. It includes the
/// points with a similar normal at distances between `from` and `to` from the contact.
double wrongBetween(
  const Press& press, const Drawn& drawn, vtkDataArray* field, double from, double to)
{
  vtkDataArray* normals = drawn.body->GetPointData()->GetArray("ResponseNormal");
  double sum = 0.0;
  int count = 0;
  for (vtkIdType i = 0; i < drawn.body->GetNumberOfPoints(); ++i)
  {
    const Vector3 x(drawn.body->GetPoint(i));
    const double r = (x - press.place).norm();
    const Vector3 normal(normals->GetTuple3(i));
    if (r >= from && r <= to && normal.dot(press.normal) > 0.7)
    {
      const Vector3 u(field->GetTuple3(i));
      const Vector3 w(drawn.truth->GetTuple3(i));
      sum += std::pow((u - w).dot(press.normal) / press.depth, 2);
      ++count;
    }
  }
  PALPATE_CHECK(count > 5);
  return std::sqrt(sum / count);
}

/// The field of a half-space at the whole depth, which is used if the body has no arrays for its
/// shape.
vtkSmartPointer<vtkDataArray> ofHalfSpace(const Press& press, const Drawn& drawn)
{
  vtkNew<vtkPolyData> plain;
  plain->ShallowCopy(drawn.body);
  plain->GetPointData()->RemoveArray("NearField");
  plain->GetFieldData()->RemoveArray("GlobalModeSign");
  const auto field = deflection(press, plain, drawn.tips);
  field->Update();
  return field->GetOutput()->GetPointData()->GetArray("ContactDisplacement");
}

/// Beyond two contact radii a patch of the same force moves the surface as the tool does: the
/// difference is (a/r)²/6 of the dent, at most 1.5 % of the depth. The other errors are those of
/// the field itself: a quadratic approximation, and the part that few modes neglect for a body
/// bonded along a side.
void checkNear(const char* name, const Press& press, double tolerance, double better)
{
  const Drawn drawn = draw(press);
  const vtkIdType point =
    drawn.body->vtkDataSet::FindPoint(press.place[0], press.place[1], press.place[2]);
  const Vector3 here(drawn.field->GetTuple3(point));
  // The surface is on the tool, except for its tangential motion.
  PALPATE_CHECK_NEAR(-here.dot(press.normal), 0.999 * press.depth, 1e-4);
  const double error = wrongBetween(press, drawn, drawn.field, 2.0, 5.0);
  const double before = wrongBetween(press, drawn, ofHalfSpace(press, drawn), 2.0, 5.0);
  std::cout << name << ": off by " << 100.0 * error << " % of the depth, a half-space by "
            << 100.0 * before << " %\n";
  PALPATE_CHECK(error < tolerance);
  PALPATE_CHECK(better * error < before);
}

Grid uniform(int side, int height)
{
  Grid grid = block(side, height);
  addCells(grid, "E", 1.0);
  return grid;
}

/// The whole of a bending column moves as its elements do, except for the dent.
void checkColumn()
{
  Grid column = uniform(4, 16);
  const Press press{ column, Vector3(4.0, 2.0, 14.0), Vector3::UnitX(), "sphere:3", 0.5 };
  const Drawn drawn = draw(press);
  double largest = 0.0;
  double off = 0.0;
  for (vtkIdType i = 0; i < drawn.body->GetNumberOfPoints(); ++i)
  {
    if ((Vector3(drawn.body->GetPoint(i)) - press.place).norm() > 2.0)
    {
      const Vector3 w(drawn.truth->GetTuple3(i));
      largest = std::max(largest, w.norm());
      off = std::max(off, (Vector3(drawn.field->GetTuple3(i)) - w).norm());
    }
  }
  std::cout << "column: off by " << off << " of " << largest << " mm\n";
  PALPATE_CHECK(largest > 0.4); // the bending exceeds the dent
  PALPATE_CHECK(off < 0.05 * largest);
}

void checkWrongArrays(const Drawn& drawn, const Press& press)
{
  vtkNew<vtkPolyData> wrong;
  wrong->ShallowCopy(drawn.body);
  vtkNew<vtkFloatArray> few;
  few->SetName("NearField");
  few->SetNumberOfComponents(3);
  few->SetNumberOfTuples(drawn.body->GetNumberOfPoints());
  few->Fill(0.0);
  wrong->GetPointData()->AddArray(few);
  const auto refused = deflection(press, wrong, drawn.tips);
  Messages messages(refused.Get());
  refused->Update();
  PALPATE_CHECK_TEXT(messages.errors(), "NearField", "12 components");

  vtkNew<vtkFloatArray> empty;
  empty->DeepCopy(drawn.body->GetPointData()->GetArray("NearField"));
  empty->Fill(std::nan(""));
  wrong->GetPointData()->AddArray(empty);
  const auto drawnWithout = deflection(press, wrong, drawn.tips);
  drawnWithout->Update();
  vtkDataArray* field = drawnWithout->GetOutput()->GetPointData()->GetArray("ContactDisplacement");
  for (vtkIdType i = 0; i < field->GetNumberOfTuples(); ++i)
  {
    PALPATE_CHECK(std::isfinite(field->GetTuple3(i)[2]));
  }
}

void checkSwitchedOff()
{
  vtkNew<vtkElasticContactResponse> response;
  response->SetInputData(uniform(4, 4));
  response->SetTool(makeTool("sphere:3"));
  response->SetMaximumDeflection(0.2);
  PALPATE_CHECK(response->GetStoreMotion());
  response->StoreMotionOff();
  Messages messages(response.Get());
  response->Update();
  PALPATE_CHECK(!response->GetOutput()->GetPointData()->HasArray("NearField"));
  PALPATE_CHECK(!response->GetOutput()->GetPointData()->HasArray("GlobalMode0"));
}
} // namespace

int TestDeflectionShape(int, char*[])
{
  const Vector3 up = Vector3::UnitZ();
  checkNear("edge", { uniform(16, 9), Vector3(3.0, 8.0, 9.0), up, "sphere:3", 0.4 }, 0.03, 2.0);
  const Press layer{ uniform(16, 3), Vector3(8.0, 8.0, 3.0), up, "sphere:3", 0.4 };
  checkNear("layer", layer, 0.03, 5.0);
  Grid nodule = withNodule(block(16, 9), 9.0, 8.0, 4.0, 3.0, 10.0);
  nodule->GetCellData()->GetArray("YoungsModulus")->SetName("E");
  checkNear("nodule", { nodule, Vector3(8.0, 8.0, 9.0), up, "sphere:3", 0.4 }, 0.03, 5.0);
  checkColumn();
  checkWrongArrays(draw(layer), layer);
  checkSwitchedOff();
  return palpate::testing::result();
}
