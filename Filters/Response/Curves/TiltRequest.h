// SPDX-License-Identifier: BSD-3-Clause
#ifndef TiltRequest_h
#define TiltRequest_h

#include <string>

class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;
class BodyMaterial;

/// How far a tool is tilted, of a response.
struct TiltRequest
{
  const AxisymmetricTool& tool;
  double degrees; ///< 0: it is upright
  double range;   ///< mm, of the curves
};

/// What is wrong with it, naming the angle, or "".
std::string checkTilts(const TiltRequest& request);

/// Attaches what the tilts make of the force, to a body with its response; nothing for 0 degrees.
/// `material` null: the tilts of a half-space, and validity stays as it is; else validity and error
/// (`tolerance` > 0) count what is not known of them. What is wrong, or "".
std::string attachTilts(const TiltRequest& request, const BodyMaterial* material, double tolerance,
  const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif
