// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/BodyYield.h"

#include "Response/BodyField.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"
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

void attachModes(const BodyYield& found, vtkPolyData* body)
{
  vtkNew<vtkSignedCharArray> signs;
  signs->SetName(GlobalModeSignArray);
  const auto numbers = static_cast<std::ptrdiff_t>(3 * found.compliance.size());
  auto from = found.modes.begin();
  for (std::size_t k = 0; k < found.signs.size(); ++k)
  {
    vtkNew<vtkFloatArray> mode;
    mode->SetName(globalModeName(static_cast<std::size_t>(k)).c_str());
    mode->SetNumberOfComponents(3);
    mode->SetNumberOfTuples(body->GetNumberOfPoints());
    std::copy(from, from + numbers, mode->GetPointer(0));
    body->GetPointData()->AddArray(mode);
    signs->InsertNextValue(found.signs[k]);
    from += numbers;
  }
  body->GetFieldData()->AddArray(signs);
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
  attachModes(found, body);
}
} // namespace palpate
