// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_TiltReference_h
#define palpate_testing_TiltReference_h

#include "Mechanics/Tilt/TiltBody.h"
#include "Mechanics/Tilt/TiltTable.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <map>
#include <string>

namespace palpate::testing
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

/// Command-line form of a tool's name in Data/Reference/tilt.
inline const std::string& tiltedToolOf(const std::string& name)
{
  static const std::map<std::string, std::string> tools = { { "cone45", "cone:45" },
    { "cone60", "cone:60" }, { "cone70", "cone:70" }, { "blunt45", "blunted:1,45" },
    { "blunt60", "blunted:1,60" }, { "flat", "flat:1" }, { "round0_25", "rounded:1,0.25" },
    { "round0.25", "rounded:1,0.25" }, { "round1", "rounded:1,1" }, { "trunc45", "truncated:1,45" },
    { "trunc60", "truncated:1,60" } };
  return tools.at(name);
}

/// Force and torque from a table for one body with E* = 1: F = F_0 τ + W_0 ∂τ/∂D, M = F dh/dθ + W_0
/// ∂τ/∂θ.
struct FeltTilt
{
  double force;
  double torque;
};

inline FeltTilt feltBy(const TiltTable& table, const AxisymmetricTool& tool, const TiltBody& body,
  double depth, double angle)
{
  const TiltFactor tau = table.at(depth, angle);
  const TiltWork upright = pressedInto(tool, body, depth);
  const double force = upright.force * tau.value + upright.work * tau.byDepth;
  return { force, force * table.deepest(angle).offset + upright.work * tau.byAngle };
}
} // namespace palpate::testing

#endif
