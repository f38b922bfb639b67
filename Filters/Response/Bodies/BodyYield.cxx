// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/BodyYield.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace palpate
{
namespace
{
template <class Array, class Value>
void attach(const char* name, const std::vector<Value>& values, vtkPolyData* body)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  body->GetPointData()->AddArray(array);
}
} // namespace

std::string findYield(vtkPolyData* body, const YieldRequest& request,
  const std::function<bool(double)>& goOn, BodyYield& made)
{
  static const LoadedModule loaded = loadModule("palpateSolidResponse");
  if (!loaded.table)
  {
    return "the deflection of the whole body needs " + missingModule("Solids", loaded.fault);
  }
  return static_cast<const YieldModule*>(loaded.table)->find(body, request, goOn, made);
}

void attachYield(const BodyYield& found, vtkPolyData* body)
{
  attach<vtkDoubleArray>(FoundCompliance, found.compliance, body);
  attach<vtkDoubleArray>("GlobalComplianceError", found.error, body);
  attach<vtkUnsignedCharArray>("ComplianceStatus", found.status, body);
}
} // namespace palpate
