// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolSpecification_h
#define palpate_ToolSpecification_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Files/NumberText.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/ProfileTool.h"

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The shapes that parseTool and makeTool know, in the order of vtkContactTool's Shape.
enum class ToolShape
{
  Flat,
  Paraboloid,
  Sphere,
  Cone,
  TruncatedCone,
  BluntedCone,
  RoundedFlat,
  PowerLaw,
  Profile
};

/// A tool's specification: a shape and its parameters (mm, degrees).
struct ToolSpecification
{
  ToolShape Shape = ToolShape::Sphere;
  double Radius = 5.0;
  double HalfAngle = 60.0;
  double EdgeRadius = 1.0;
  double Exponent = 2.0;
  double Coefficient = 0.1;
  std::vector<ProfilePoint> Profile = {};
};

/// Returns the forms of text that parseTool() accepts, for the help of programs: "flat:R, sphere:R,
/// …".
PALPATE_EXPORT const char* toolSyntax();

/// Returns the fault of the specification with the parameter and its value, or "".
PALPATE_EXPORT std::string checkTool(const ToolSpecification& specification);

/// Creates the tool; null if checkTool() reports a fault.
PALPATE_EXPORT std::unique_ptr<AxisymmetricTool> makeTool(const ToolSpecification& specification);

/**
 * Reads the specification of a tool from one of these forms:
 *   flat:R  sphere:R  paraboloid:R  cone:DEGREES  truncated:R,DEGREES  blunted:R,DEGREES
 *   rounded:R,EDGE  power:EXPONENT,COEFFICIENT  profile:FILE.csv  profile:r1,f1;r2,f2;…
 * with lengths in mm and angles in degrees from the axis. The second form of a profile is
 * recognised by its ';'. specification() writes the second form, so that a stored response needs no
 * file. For files see ProfileFile.h. On failure the function returns false, sets `error`, and
 * leaves the specification unchanged.
 */
PALPATE_EXPORT bool parseTool(
  const std::string& text, ToolSpecification& specification, std::string& error);

/// Returns the parsed specification of a tool; empty if it cannot be parsed.
PALPATE_EXPORT std::optional<ToolSpecification> knownSpecification(const AxisymmetricTool& tool);

/// Returns the tool with all lengths multiplied by `factor` > 0. Its force law is F(δ) → factor²
/// F(δ/factor). A cone and a power law of exponent 1 have no length; for these tools tan α is
/// multiplied by the factor. Returns null if the tool's specification cannot be parsed, or if the
/// scaled specification is invalid.
PALPATE_EXPORT std::unique_ptr<AxisymmetricTool> scaledTool(
  const AxisymmetricTool& tool, double factor);

/// Returns "name:v1,v2" with the shortest decimals.
PALPATE_EXPORT std::string formatTool(
  const std::string& name, std::initializer_list<double> values);
/// Returns "profile:r1,f1;r2,f2;…" with the shortest decimals.
PALPATE_EXPORT std::string formatProfile(const std::vector<ProfilePoint>& points);
} // namespace palpate

#endif
