// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeasuredMaterial_h
#define MeasuredMaterial_h

#include "MeasuredResponse/SiteMeasurement.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// Names of the point arrays between the identified sites and vtkToolContactResponse.
namespace MeasuredMaterial
{
constexpr const char* ModulusArray = "IdentifiedModulus";
constexpr const char* ComplianceArray = "IdentifiedCompliance";
constexpr const char* ThicknessArray = "IdentifiedThickness";
constexpr const char* YoungArray = "palpate:YoungsModulus"; ///< removed in the end
} // namespace MeasuredMaterial

/// Makes `spread` the body with the material of its points: E*, C_g and 1/h of the sites that are
/// not refused, interpolated within `reach` (mm).
void spreadMaterial(vtkPolyData* body, double poissonsRatio, double reach,
  SiteMeasurement& measurement, vtkPolyData* spread);

/// Removes the response `name` where no site reaches, marks elsewhere where the data end
/// (DataEnd.h), and describes in its field arrays what it was measured from. `range`: its depth,
/// mm.
void limitToData(
  const SiteMeasurement& measurement, const std::string& name, double range, vtkPolyData* output);
} // namespace palpate

#endif
