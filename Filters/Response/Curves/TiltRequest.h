// SPDX-License-Identifier: BSD-3-Clause
#ifndef TiltRequest_h
#define TiltRequest_h

#include "palpateResponseModule.h"

#include <string>

class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;
class BodyMaterial;

/// The largest tilt of the tool of a response.
struct TiltRequest
{
  const AxisymmetricTool& tool;
  double degrees; ///< 0: the tool is upright
  double range;   ///< range of the curves, mm
};

/// Checks the request. Returns "" or an error that names the angle.
PALPATERESPONSE_EXPORT std::string checkTilts(const TiltRequest& request);

/// Attaches the tilts to a body with its response; has no effect for 0 degrees. `material` null:
/// attaches the tilts of a half-space and does not change validity. Otherwise validity and error
/// (`tolerance` > 0) include the error of the tilts. Returns "" or an error message.
PALPATERESPONSE_EXPORT std::string attachTilts(const TiltRequest& request,
  const BodyMaterial* material, double tolerance, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif
