// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeasuredMaterial_h
#define MeasuredMaterial_h

#include "MeasuredResponse/SiteMeasurement.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// Names of the point arrays through which vtkToolContactResponse receives the identified material.
namespace MeasuredMaterial
{
constexpr const char* ModulusArray = "IdentifiedModulus";
constexpr const char* ComplianceArray = "IdentifiedCompliance";
constexpr const char* ThicknessArray = "IdentifiedThickness";
/// Removed from the output before the filter ends.
constexpr const char* YoungArray = "palpate:YoungsModulus";
} // namespace MeasuredMaterial

/// Makes `spread` a copy of the body with the material at its points: E*, C_g and 1/h of the sites
/// that are not refused, interpolated within `reach` (mm).
void spreadMaterial(vtkPolyData* body, double poissonRatio, double reach,
  SiteMeasurement& measurement, vtkPolyData* spread);

/// Removes the response `name` at points beyond the reach of all sites. At the other points the
/// validity is limited to the end of the data (DataEnd.h). Adds a description of the measured data
/// to the field arrays. `range` is the range of the response, mm.
void limitToData(
  const SiteMeasurement& measurement, const std::string& name, double range, vtkPolyData* output);
} // namespace palpate

#endif
