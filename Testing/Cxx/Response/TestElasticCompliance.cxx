// SPDX-License-Identifier: BSD-3-Clause
// vtkElasticCompliance: its output, its arrays to process, both solvers, errors, abort. Accuracy:
// TestElasticComplianceLayer, TestElasticCompliancePlate.
#include "FilterChecks.h"
#include "TestBodies.h"
#include "VolumeBlock.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkElasticCompliance.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <vector>

namespace
{
using namespace palpate::testing;
vtkSmartPointer<vtkElasticCompliance> makeFilter(vtkUnstructuredGrid* grid)
{
  auto filter = vtkSmartPointer<vtkElasticCompliance>::New();
  filter->SetInputData(grid);
  return filter;
}

std::vector<double> values(vtkElasticCompliance* filter, const char* name = "GlobalCompliance")
{
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
  std::vector<double> found;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    found.push_back(array->GetTuple1(i));
  }
  return found;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = a.size() == b.size() && !a.empty() ? 0.0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

double largest(const std::vector<double>& a)
{
  double most = 0.0;
  for (const double x : a)
  {
    most = std::max(most, std::abs(x));
  }
  return most;
}

void checkOutput()
{
  const Grid grid = block(6, 4);
  const auto filter = makeFilter(grid);
  Messages messages(filter.Get());
  filter->Update();
  PALPATE_CHECK(messages.none());
  vtkPolyData* surface = filter->GetOutput();
  // 7 × 7 × 5 points without the 5 × 5 × 3 inner ones; two triangles per outer square.
  PALPATE_CHECK(surface->GetNumberOfPoints() == 245 - 75);
  PALPATE_CHECK(surface->GetNumberOfPolys() == 2 * (2 * 36 + 4 * 24));
  vtkPointData* data = surface->GetPointData();
  PALPATE_CHECK(data->GetArray("GlobalCompliance")->GetDataType() == VTK_DOUBLE);
  PALPATE_CHECK(data->GetArray("ComplianceStatus")->GetDataType() == VTK_UNSIGNED_CHAR);
  PALPATE_CHECK(data->GetArray("OriginalPointIds")->GetDataType() == VTK_ID_TYPE);
  int valid = 0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(data->GetArray("OriginalPointIds")->GetTuple1(i));
    PALPATE_CHECK(surface->GetPoint(i)[2] == grid->GetPoint(id)[2]);
    PALPATE_CHECK(data->GetArray("Height")->GetTuple1(i) == grid->GetPoint(id)[2]);
    PALPATE_CHECK(std::isfinite(data->GetArray("GlobalCompliance")->GetTuple1(i)));
    valid += data->GetArray("ComplianceStatus")->GetTuple1(i) == 0 ? 1 : 0;
  }
  // Patches of 0.75 and 1.5 mm. Their outermost force is at 0.94 of the radius, so a valid point is
  // two points from an edge. The top has 3 × 3 valid points. A side has none, because its lowest
  // row of faces has fixed points.
  PALPATE_CHECK(valid == 9);
  const vtkIdType top = surface->vtkDataSet::FindPoint(3.0, 3.0, 4.0);
  PALPATE_CHECK(data->GetArray("GlobalCompliance")->GetTuple1(top) < 0.0); // the base is 4 mm below
}

void checkKindsAndSolvers()
{
  const auto voxels = makeFilter(block(6, 3));
  const auto hexahedra = makeFilter(block(6, 3, VTK_HEXAHEDRON));
  voxels->Update();
  hexahedra->Update();
  const std::vector<double> expected = values(voxels);
  const double scale = largest(expected);
  PALPATE_CHECK(scale > 0.0 && largestDifference(expected, values(hexahedra)) < 1e-12 * scale);
  for (const int solver : { 1, 2 })
  {
    const auto other = makeFilter(block(6, 3));
    Messages messages(other.Get());
    other->SetSolver(solver);
    other->Update();
    if (solver == vtkElasticCompliance::Supernodal && !messages.errors().empty())
    {
      PALPATE_CHECK_TEXT(messages.takeErrors(), "CHOLMOD");
      continue;
    }
    // The solvers differ by rounding times the condition number; 1e-9 is guaranteed.
    PALPATE_CHECK(largestDifference(expected, values(other)) < 1e-9 * scale);
  }
}

void checkMaterialArrays()
{
  const Grid grid = block(5, 3);
  addCells(grid, "E", 0.4);
  addCells(grid, "nu", 0.3);
  const auto constant = makeFilter(grid);
  constant->SetYoungsModulus(0.4);
  constant->SetPoissonRatio(0.3);
  constant->Update();
  const auto arrays = makeFilter(grid);
  arrays->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "E");
  arrays->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "nu");
  arrays->Update();
  const std::vector<double> expected = values(constant);
  PALPATE_CHECK(largestDifference(expected, values(arrays)) < 1e-12 * largest(expected));
  arrays->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "");
  arrays->SetYoungsModulus(0.2); // the compliance is proportional to 1/E
  arrays->Update();
  std::vector<double> half = values(arrays);
  for (double& x : half)
  {
    x *= 0.5;
  }
  PALPATE_CHECK(largestDifference(expected, half) < 1e-9 * largest(expected));
}

/// Betti's theorem: the motion of b along the load at b, under 1 N at a, equals the motion of a
/// under 1 N at b.
void checkLoadedDisplacement()
{
  const auto filter = makeFilter(block(8, 4));
  filter->Update();
  const vtkIdType a = filter->GetOutput()->vtkDataSet::FindPoint(4.0, 4.0, 4.0);
  const vtkIdType b = filter->GetOutput()->vtkDataSet::FindPoint(6.0, 4.0, 4.0);
  PALPATE_CHECK(filter->GetOutput()->GetPointData()->GetArray("LoadedDisplacement") == nullptr);
  const auto moved = [&](vtkIdType loaded, vtkIdType seen, double force)
  {
    filter->SetLoadedPoint(loaded);
    filter->SetLoadForce(force);
    filter->Update();
    return filter->GetOutput()
      ->GetPointData()
      ->GetArray("LoadedDisplacement")
      ->GetComponent(seen, 2);
  };
  PALPATE_CHECK(moved(a, a, 1.0) < moved(a, b, 1.0) && moved(a, b, 1.0) < 0.0);
  PALPATE_CHECK_NEAR(moved(a, a, 3.0), 3.0 * moved(a, a, 1.0), 1e-9);
  const double there = moved(a, b, 1.0);
  // The two are not exactly equal, because the load acts on a patch and the motion is that of a
  // point.
  PALPATE_CHECK_NEAR(moved(b, a, 1.0), there, 0.1 * std::abs(there));
}

/// The error of the elements changes the stated error of the force by dF/dδ times this error, and
/// changes nothing else.
void checkErrorOfForce()
{
  const auto filter = makeFilter(block(12, 5));
  filter->SetYoungsModulus(0.1);
  filter->Update();
  const auto body = vtkSmartPointer<vtkPolyData>::New();
  body->ShallowCopy(filter->GetOutput());
  const std::vector<double> errors = values(filter, "GlobalComplianceError");
  PALPATE_CHECK(errors.size() == static_cast<std::size_t>(body->GetNumberOfPoints()));
  const auto felt = [&](vtkPolyData* on)
  {
    auto response = filterOf(on, "sphere:2", 0.5);
    response->SetInputArrayToProcess(
      2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "GlobalCompliance");
    return response;
  };
  const auto with = felt(body);
  with->Update();
  const auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->ShallowCopy(body);
  bare->GetPointData()->RemoveArray("GlobalComplianceError");
  const auto without = felt(bare);
  without->Update();
  const vtkIdType top = body->vtkDataSet::FindPoint(6.0, 6.0, 5.0);
  const auto last = [top](vtkToolContactResponse* response, const char* array)
  { return response->GetOutput()->GetPointData()->GetArray(array)->GetComponent(top, 7); };
  PALPATE_CHECK(errors[static_cast<std::size_t>(top)] > 0.0);
  PALPATE_CHECK(last(with, "ResponseForce") == last(without, "ResponseForce"));
  const double part = errors[static_cast<std::size_t>(top)] * last(with, "ResponseStiffness");
  // Error and stiffness are stored as floats. The stored law of a sphere has an error of 1e-3.
  PALPATE_CHECK_NEAR(
    last(with, "ResponseError") - last(without, "ResponseError"), part, 2e-3 * part);

  // A dominant error of the compliance sets the limit; an invalid one is rejected.
  vtkNew<vtkDoubleArray> stated;
  stated->SetName("GlobalComplianceError");
  stated->SetNumberOfTuples(body->GetNumberOfPoints());
  stated->Fill(100.0);
  body->GetPointData()->AddArray(stated);
  with->Modified();
  with->Update();
  PALPATE_CHECK(with->GetOutput()->GetPointData()->GetArray("ResponseLimit")->GetTuple1(top) == 7);
  stated->SetValue(3, -1.0);
  Messages messages(with.Get());
  with->Modified();
  with->Update();
  PALPATE_CHECK_TEXT(messages.takeErrors(), "GlobalComplianceError", "point 3", "-1");
}

void checkErrors()
{
  const auto fails =
    [](vtkUnstructuredGrid* grid, auto&& change, std::initializer_list<const char*> words)
  {
    const auto filter = makeFilter(grid);
    Messages messages(filter.Get());
    change(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  const auto nothing = [](vtkElasticCompliance*) {};
  Grid grid = block(3, 3);
  fails(grid, [](auto* f) { f->SetPoissonRatio(0.4995); }, { "Poisson's Ratio", "0.4995" });
  fails(grid, [](auto* f) { f->SetYoungsModulus(0.0); }, { "Young's Modulus", "0" });
  fails(grid, [](auto* f) { f->SetYoungsModulus(std::nan("")); }, { "Young's Modulus", "nan" });
  fails(grid, [](auto* f) { f->SetPatchRadius(-1.0); }, { "Patch Radius", "-1" });
  fails(grid, [](auto* f) { f->SetLoadedPoint(5000); }, { "Loaded Point", "5000" });
  fails(grid,
    [](auto* f)
    { f->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Stiff"); },
    { "Stiff", "cells" });
  addCells(grid, "E", 1.0);
  grid->GetCellData()->GetArray("E")->SetTuple1(4, -3.0);
  fails(grid,
    [](auto* f)
    { f->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "E"); },
    { "cell 4", "-3" });
  grid->GetPointData()->GetArray("Fixed")->SetTuple1(9, 8.0);
  fails(grid, nothing, { "Fixed", "point 9", "8" });
  grid->GetPointData()->RemoveArray("Fixed");
  fails(grid, nothing, { "no point array 'Fixed'" });

  grid = block(3, 3);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPointData()->GetArray("Fixed")->SetTuple1(i, i < 16 ? 4 : 0); // 4: held along z only
  }
  fails(grid, nothing, { "floating", "cell 0", "3 of 6" });

  grid = block(3, 3);
  grid->GetPoints()->SetPoint(20, 1.0, std::nan(""), 1.0);
  fails(grid, nothing, { "point 20" });

  grid = block(2, 1);
  const vtkIdType wedge[6] = { 0, 1, 3, 9, 10, 12 };
  grid->InsertNextCell(VTK_WEDGE, 6, wedge);
  fails(grid, nothing, { "cell 4", "Wedge" });

  grid = block(2, 1, VTK_HEXAHEDRON);
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(2, ids);
  std::array<vtkIdType, 8> turned{};
  for (vtkIdType i = 0; i < 8; ++i)
  {
    // upside down: the cell is inverted
    turned[static_cast<std::size_t>(i)] = ids->GetId((i + 4) % 8);
  }
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, turned.data());
  fails(grid, nothing, { "cell" });
  auto inverted = Grid::New();
  inverted->SetPoints(grid->GetPoints());
  inverted->GetPointData()->ShallowCopy(grid->GetPointData());
  inverted->InsertNextCell(VTK_HEXAHEDRON, 8, turned.data());
  fails(inverted, nothing, { "cell 0 is inverted" });

  const auto empty = makeFilter(Grid::New());
  Messages messages(empty.Get());
  empty->Update();
  PALPATE_CHECK(messages.none() && empty->GetOutput()->GetNumberOfPoints() == 0);
}

void checkProgressAndAbort()
{
  std::vector<double> seen;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&seen);
  observer->SetCallback([](vtkObject*, unsigned long, void* client, void* data)
    { static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(data)); });
  const auto filter = makeFilter(block(5, 3));
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  PALPATE_CHECK(seen.size() >= 6 && std::is_sorted(seen.begin(), seen.end()));
  PALPATE_CHECK(seen.back() == 1.0);
  PALPATE_CHECK(filter->GetMemoryEstimate() > 0.0);

  for (const double at : { 0.04, 0.09, 0.39, 0.41, 0.6, 0.71 })
  {
    const auto aborted = makeFilter(block(5, 3));
    Messages messages(aborted.Get());
    const AbortAfter abort(aborted, at);
    aborted->Update();
    PALPATE_CHECK(messages.none() && aborted->GetOutput()->GetNumberOfPoints() == 0);
  }
}
} // namespace

int TestElasticCompliance(int, char*[])
{
  checkOutput();
  checkKindsAndSolvers();
  checkMaterialArrays();
  checkLoadedDisplacement();
  checkErrorOfForce();
  checkErrors();
  checkProgressAndAbort();
  return palpate::testing::result();
}
