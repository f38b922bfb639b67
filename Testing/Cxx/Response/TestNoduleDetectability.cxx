// SPDX-License-Identifier: BSD-3-Clause
// vtkNoduleDetectability: its responses against vtkElasticContactResponse, its changes against a
// search over all samples, solutions kept for the next tool, threads, faults, abort.
// TestNoduleTable compares with a table.
#include "AbortedFilter.h"
#include "FilterChecks.h"
#include "NoduleBodies.h"

#include "vtkDataObject.h"
#include "vtkElasticContactResponse.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string>

namespace
{
using namespace palpate::testing;

/// A block of 10 x 10 x 4 mm with a hard ball in its middle.
Grid smallBody()
{
  return withNodule(block(10, 4), 5.0, 5.0, 2.2, 1.2, 10.0);
}

bool isSame(vtkDataArray* a, vtkDataArray* b)
{
  bool same =
    a && b && a->GetNumberOfValues() > 0 && a->GetNumberOfValues() == b->GetNumberOfValues();
  for (vtkIdType i = 0; same && i < a->GetNumberOfValues(); ++i)
  {
    same = a->GetVariantValue(i) == b->GetVariantValue(i) ||
      (std::isnan(a->GetVariantValue(i).ToDouble()) &&
        std::isnan(b->GetVariantValue(i).ToDouble()));
  }
  return same;
}

vtkDataArray* arrayOf(vtkPolyDataAlgorithm* filter, const std::string& name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name.c_str());
}

/// Both responses are bit for bit those of vtkElasticContactResponse.
void checkResponses()
{
  const Grid grid = smallBody();
  const Detectability both = felt(grid, "sphere:2", 0.5);
  both->AddMoreTool("flat:0.8");
  both->StoreWithoutOn();
  both->Update();
  vtkNew<vtkElasticContactResponse> one;
  one->SetInputData(grid);
  one->SetMaximumDeflection(0.5);
  // The sphere has the widest contact, which determines the number of solutions.
  one->SetLargestContactRadius(1.42 * makeTool("sphere:2")->GetContactRadius(0.5));
  for (const bool with : { true, false })
  {
    const std::string behind = with ? "" : "Without";
    one->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, ("YoungsModulus" + behind).c_str());
    one->SetInputArrayToProcess(
      1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, ("PoissonRatio" + behind).c_str());
    for (const auto& [tool, name] :
      std::map<std::string, std::string>{ { "sphere:2", "Response" }, { "flat:0.8", "Response2" } })
    {
      one->SetTool(makeTool(tool));
      one->Update();
      for (const char* what : { "Force", "Stiffness", "Range", "Status", "Validity", "Error" })
      {
        PALPATE_CHECK(isSame(
          arrayOf(one, std::string("Response") + what), arrayOf(both, name + behind + what)));
      }
    }
  }
  const Detectability bare = felt(grid, "sphere:2", 0.5);
  bare->Update();
  PALPATE_CHECK(!arrayOf(bare, "ResponseWithoutForce"));
  PALPATE_CHECK(arrayOf(bare, "ForceChange")->GetNumberOfComponents() == 1);
}

/// The changes against the largest change over the samples of curves with many samples.
void checkChanges()
{
  const Grid grid = smallBody();
  const Detectability filter = felt(grid, "sphere:2", 0.5);
  filter->SetNumberOfSamples(64);
  filter->StoreWithoutOn();
  filter->Update();
  int known = 0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double change = arrayOf(filter, "ForceChange")->GetTuple1(i);
    if (arrayOf(filter, "ResponseStatus")->GetTuple1(i) != 0.0 ||
      arrayOf(filter, "ResponseWithoutStatus")->GetTuple1(i) != 0.0)
    {
      PALPATE_CHECK(std::isnan(change));
      PALPATE_CHECK(arrayOf(filter, "Felt")->GetTuple1(i) == 0.0);
      PALPATE_CHECK(arrayOf(filter, "StrongestTool")->GetTuple1(i) == -1.0);
      continue;
    }
    PALPATE_CHECK(arrayOf(filter, "Felt")->GetTuple1(i) == (std::abs(change) >= 0.1 ? 1.0 : 0.0));
    const double range = arrayOf(filter, "ResponseRange")->GetTuple1(i);
    PALPATE_CHECK(arrayOf(filter, "ChangeDepth")->GetTuple1(i) <= 0.5 + 1e-6);
    if (range != arrayOf(filter, "ResponseWithoutRange")->GetTuple1(i))
    {
      continue; // the samples of the two curves have different depths
    }
    ++known;
    double most = 0.0;
    double stiffness = 0.0;
    for (int k = 0; k < 64; ++k)
    {
      const auto changeOf = [&](const char* what)
      {
        return arrayOf(filter, std::string("Response") + what)->GetComponent(i, k) /
          arrayOf(filter, std::string("ResponseWithout") + what)->GetComponent(i, k) -
          1.0;
      };
      if (std::abs(changeOf("Force")) > std::abs(most))
      {
        most = changeOf("Force");
        stiffness = changeOf("Stiffness");
      }
    }
    // Between 64 samples the error is a hundredth of the largest change. Near a flat maximum the
    // depth, and with it the stiffness, may differ.
    PALPATE_CHECK_NEAR(change, most, 0.01 * std::abs(most) + 1e-5);
    PALPATE_CHECK_NEAR(arrayOf(filter, "StiffnessChange")->GetTuple1(i), stiffness,
      0.1 * std::abs(stiffness) + 1e-3);
  }
  PALPATE_CHECK(known > 30);

  // The search does not go beyond the validity, which ends before the range.
  filter->WithinValidityOn();
  filter->Update();
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double depth = arrayOf(filter, "ChangeDepth")->GetTuple1(i);
    PALPATE_CHECK(std::isnan(depth) ||
      depth <= 1e-6 +
          std::min(arrayOf(filter, "ResponseValidity")->GetTuple1(i),
            arrayOf(filter, "ResponseWithoutValidity")->GetTuple1(i)));
  }
  PALPATE_CHECK(filter->GetNumberOfSolutions() == 0);
  filter->WithinValidityOff();
  filter->SetPressDepth(0.2);
  filter->Update();
  PALPATE_CHECK_NEAR(arrayOf(filter, "ChangeDepth")->GetRange()[1], 0.2, 1e-6);
  PALPATE_CHECK(filter->GetNumberOfSolutions() == 0);
}

/// A body without nodules has no detectable change.
void checkNothing()
{
  vtkNew<vtkNoduleMaterial> plain;
  plain->SetInputData(block(8, 3));
  plain->Update();
  const Detectability filter = felt(plain->GetOutput(), "sphere:2", 0.4);
  filter->Update();
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double change = arrayOf(filter, "ForceChange")->GetTuple1(i);
    PALPATE_CHECK(std::isnan(change) || change == 0.0);
    PALPATE_CHECK(arrayOf(filter, "Felt")->GetTuple1(i) == 0.0);
  }
}

void checkKeptAndThreads()
{
  const Grid grid = smallBody();
  const Detectability filter = felt(grid, "sphere:2", 0.5);
  filter->Update();
  const vtkIdType solved = filter->GetNumberOfSolutions();
  PALPATE_CHECK(solved > 0 && filter->GetMemoryEstimate() > 0.0);
  filter->SetTool(makeTool("flat:0.8"));
  filter->SetThreshold(0.05);
  filter->Update();
  PALPATE_CHECK(filter->GetNumberOfSolutions() == 0);
  filter->AddMoreTool("sphere:8"); // this tool has a wider contact
  filter->Update();
  PALPATE_CHECK(filter->GetNumberOfSolutions() == solved);
  const vtkSmartPointer<vtkDataArray> expected = arrayOf(filter, "ForceChange");
  withThreads(1,
    [&]
    {
      const Detectability again = felt(grid, "flat:0.8", 0.5);
      again->AddMoreTool("sphere:8");
      again->Update();
      PALPATE_CHECK(isSame(arrayOf(again, "ForceChange"), expected));
    });
}

void checkErrors()
{
  const Grid grid = smallBody();
  const auto fails =
    [](vtkUnstructuredGrid* body, auto&& change, std::initializer_list<const char*> words)
  {
    const Detectability filter = felt(body, "sphere:1.6", 0.4);
    Messages messages(filter.Get());
    change(filter.Get());
    filter->Update();
    checkText(messages.errors(), words, __FILE__, __LINE__);
    PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  fails(grid, [](auto* f) { f->SetTool(nullptr); }, { "Tool", "SetTool" });
  fails(grid, [](auto* f) { f->AddMoreTool("spere:1"); }, { "More Tools", "spere" });
  fails(grid, [](auto* f) { f->SetThreshold(0.0); }, { "Threshold", "0" });
  fails(grid, [](auto* f) { f->SetThreshold(std::nan("")); }, { "Threshold", "nan" });
  fails(grid, [](auto* f) { f->SetMaximumDeflection(-1.0); }, { "Maximum Deflection", "-1" });
  fails(grid, [](auto* f) { f->SetPressDepth(-0.1); }, { "Press Depth", "-0.1" });
  fails(grid, [](auto* f) { f->SetNumberOfSamples(1); }, { "Number Of Samples", "1" });
  fails(grid, [](auto* f) { f->SetSourceSpacing(-1.0); }, { "SourceSpacing", "-1" });
  fails(grid, [](auto* f) { f->SetSourceSpacingWithout(-1.0); }, { "SourceSpacingWithout", "-1" });
  fails(
    grid, [](auto* f) { f->SetLargestContactRadius(-1.0); }, { "Largest Contact Radius", "-1" });
  fails(grid, [](auto* f) { f->SetMemoryLimit(0.01); }, { "Memory Limit", "MiB" });
  fails(grid, [](auto* f) { f->SetSolver(7); }, { "Solver", "7" });
  const auto nothing = [](vtkNoduleDetectability*) {};
  fails(block(4, 2), nothing, { "YoungsModulus", "cells" });
  const Grid half = smallBody();
  half->GetCellData()->RemoveArray("PoissonRatioWithout");
  fails(half, nothing, { "PoissonRatioWithout", "cells" });
  fails(grid,
    [](auto* f) { f->SetInputArrayToProcess(2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, ""); },
    { "Array to process 2" });
  const Grid free = smallBody();
  free->GetPointData()->RemoveArray("Fixed");
  fails(free, nothing, { "no point array 'Fixed'" });
  const Detectability empty = felt(Grid::New(), "sphere:1.6", 0.4);
  Messages messages(empty.Get());
  empty->Update();
  PALPATE_CHECK(messages.none() && empty->GetOutput()->GetNumberOfPoints() == 0);
}

void checkAbort()
{
  for (const double at : { 0.01, 0.2, 0.5, 0.7, 0.92 })
  {
    checkAborted(felt(smallBody(), "sphere:1.6", 0.4).Get(), at);
  }
}
} // namespace

int TestNoduleDetectability(int, char*[])
{
  checkResponses();
  checkChanges();
  checkNothing();
  checkKeptAndThreads();
  checkErrors();
  checkAbort();
  return result();
}
