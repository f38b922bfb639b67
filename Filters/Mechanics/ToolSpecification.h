// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolSpecification_h
#define palpate_ToolSpecification_h

#include "AxisymmetricTool.h"

#include <initializer_list>
#include <memory>
#include <string>

namespace palpate
{
/// The shapes parseTool and makeTool know, in the order of vtkContactTool's Shape.
enum class ToolShape
{
  Flat,
  Paraboloid,
  Sphere,
  Cone
};

/// A tool in writing: a shape and its one parameter, the radius (mm) or, for a cone, the half angle
/// (degrees).
struct ToolSpecification
{
  ToolShape Shape = ToolShape::Sphere;
  double Parameter = 5.0;
};

/// What is wrong with the specification, naming the parameter and its value; empty if nothing is.
std::string checkTool(const ToolSpecification& specification);

/// The tool, or null if checkTool finds fault.
std::unique_ptr<AxisymmetricTool> makeTool(const ToolSpecification& specification);

/// Reads "flat:R", "paraboloid:R", "sphere:R" (mm) or "cone:DEGREES" (from the axis). Returns false
/// and says in `error` what is wrong and what is accepted.
bool parseTool(const std::string& text, ToolSpecification& specification, std::string& error);

/// "name:v1,v2" with the shortest decimals that read back to the same bits.
std::string formatTool(const std::string& name, std::initializer_list<double> values);
} // namespace palpate

#endif
