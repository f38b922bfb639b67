// SPDX-License-Identifier: BSD-3-Clause
// vtkToolContactResponse in a pipeline: threads, progress, abort, modification times.
#include "FilterChecks.h"
#include "TestBodies.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"

#include <cstring>
#include <vector>

namespace
{
using namespace palpate::testing;

vtkSmartPointer<vtkToolContactResponse> makeFilter(vtkPolyData* body)
{
  auto filter = vtkSmartPointer<vtkToolContactResponse>::New();
  filter->SetInputData(body);
  filter->SetTool(makeTool("sphere:5"));
  return filter;
}

bool sameBits(vtkPolyData* a, vtkPolyData* b)
{
  bool same = a->GetPointData()->GetNumberOfArrays() == b->GetPointData()->GetNumberOfArrays();
  for (int k = 0; same && k < a->GetPointData()->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* left = a->GetPointData()->GetArray(k);
    vtkDataArray* right = b->GetPointData()->GetArray(k);
    const std::size_t bytes = static_cast<std::size_t>(left->GetNumberOfValues()) *
      static_cast<std::size_t>(left->GetDataTypeSize());
    same = left->GetNumberOfValues() == right->GetNumberOfValues() &&
      std::memcmp(left->GetVoidPointer(0), right->GetVoidPointer(0), bytes) == 0;
  }
  return same;
}

/// The cases that use different code: normals given or not, constant modulus, arrays of modulus and
/// compliance.
void checkThreads()
{
  for (const bool normals : { false, true })
  {
    for (const bool arrays : { false, true })
    {
      Body body = sphereBody(30.0, 4);
      if (normals)
      {
        addRadialNormals(body);
      }
      pointArray(body, "E", [](vtkIdType i) { return 0.1 + 0.01 * static_cast<double>(i % 17); });
      pointArray(body, "C", [](vtkIdType i) { return 0.1 * static_cast<double>(i % 3); });
      Body reference;
      for (const int threads : { 1, 2, 8 })
      {
        auto filter = makeFilter(body);
        if (arrays)
        {
          filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "E");
          filter->SetInputArrayToProcess(2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "C");
        }
        withThreads(threads, [&] { filter->Update(); });
        if (!reference)
        {
          reference = filter->GetOutput();
          PALPATE_CHECK(reference->GetPointData()->GetArray("ResponseForce") != nullptr);
        }
        PALPATE_CHECK(sameBits(reference, filter->GetOutput()));
      }
    }
  }
}

void checkProgress()
{
  std::vector<double> seen;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&seen);
  observer->SetCallback([](vtkObject*, unsigned long, void* client, void* data)
    { static_cast<std::vector<double>*>(client)->push_back(*static_cast<double*>(data)); });
  auto filter = makeFilter(sphereBody(30.0, 3));
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  PALPATE_CHECK(seen.size() >= 5 && std::is_sorted(seen.begin(), seen.end()));
  PALPATE_CHECK(seen.front() >= 0.0 && seen.back() == 1.0);
}

void checkAbort()
{
  auto filter = makeFilter(sphereBody(30.0, 3));
  Messages messages(filter.Get());
  {
    const AbortAfter abort(filter, 0.3);
    filter->Update();
  }
  PALPATE_CHECK(filter->GetOutput()->GetNumberOfPoints() == 0);
  PALPATE_CHECK(filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0);
  PALPATE_CHECK(messages.none());
  filter->AbortExecuteOff();
  filter->Modified();
  filter->Update();
  PALPATE_CHECK(filter->GetOutput()->GetPointData()->GetArray("ResponseForce") != nullptr);
}

void checkModification()
{
  const auto tool = makeTool("sphere:5");
  const auto other = makeTool("flat:5");
  auto filter = makeFilter(planeBody(10.0, 2));
  const auto firstForce = [&]
  {
    filter->Update();
    return filter->GetOutput()->GetPointData()->GetArray("ResponseForce")->GetComponent(0, 0);
  };
  filter->SetTool(tool);
  const vtkMTimeType before = filter->GetMTime();
  filter->SetTool(tool); // setting the same tool is not a modification
  PALPATE_CHECK(filter->GetMTime() == before);
  const double sphere = firstForce();
  tool->SetRadius(20.0);
  PALPATE_CHECK(filter->GetMTime() > before);
  PALPATE_CHECK(firstForce() > 1.5 * sphere); // the force is about proportional to √R
  filter->SetTool(other);
  PALPATE_CHECK(firstForce() != sphere && filter->GetTool() == other.Get());
  const vtkMTimeType withOther = filter->GetMTime();
  tool->SetRadius(1.0); // the filter no longer uses this tool
  PALPATE_CHECK(filter->GetMTime() == withOther);
}
} // namespace

int TestResponseExecution(int, char*[])
{
  checkThreads();
  checkProgress();
  checkAbort();
  checkModification();
  return palpate::testing::result();
}
