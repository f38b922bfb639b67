// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/BodyYield.h"

#include "Mechanics/ReducedModulus.h"
#include "Response/BodyConversion.h"
#include "Response/BodyField.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

bool isAccurate(const BodyYield& found, vtkPolyData* body, const YieldRequest& request)
{
  constexpr double shareOfCompliance = 0.5;
  constexpr double shareOfDeflection = 0.25;
  // Compliance of a flat round end on a half-space, mm/N.
  const double local =
    1.0 / (2.0 * reducedModulus(request.youngsModulus, request.poissonRatio) * request.radius);
  const std::vector<double> points = copyPoints(body);
  const std::vector<std::int32_t> corners = copyTriangles(body);
  double known = 0.0;
  double accurate = 0.0;
  for (std::size_t t = 0; !found.compliance.empty() && t + 2 < corners.size(); t += 3)
  {
    Eigen::Matrix3d places;
    bool isKnown = true;
    bool isWithin = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto point = static_cast<std::size_t>(corners[t + k]);
      const double compliance = found.compliance[point];
      places.col(static_cast<Eigen::Index>(k)) = Eigen::Vector3d(points.data() + 3 * point);
      isKnown = isKnown && compliance != 0.0; // below 0 where the body is stiffer than a half-space
      isWithin = isWithin &&
        found.error[point] < std::max(shareOfCompliance * std::abs(compliance),
                               shareOfDeflection * (local + compliance));
    }
    const double area = (places.col(1) - places.col(0)).cross(places.col(2) - places.col(0)).norm();
    known += isKnown ? area : 0.0;
    accurate += isKnown && isWithin ? area : 0.0;
  }
  return known > 0.0 && accurate >= 0.5 * known;
}

void attachYield(const BodyYield& found, vtkPolyData* body)
{
  attach<vtkDoubleArray>(FoundCompliance, found.compliance, body);
  attach<vtkDoubleArray>("GlobalComplianceError", found.error, body);
  attach<vtkUnsignedCharArray>("ComplianceStatus", found.status, body);
  attachModes(found, body);
}
} // namespace palpate
