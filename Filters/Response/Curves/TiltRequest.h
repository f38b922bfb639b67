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

/// How far the tool of a response is tilted.
struct TiltRequest
{
  const AxisymmetricTool& tool;
  double degrees; ///< 0: it is upright
  double range;   ///< mm, of the curves
};

/// What is wrong with it, naming the angle, or "".
PALPATERESPONSE_EXPORT std::string checkTilts(const TiltRequest& request);

/// Attaches the tilts to a body with its response; nothing for 0 degrees. `material` null: the
/// tilts of a half-space, and validity is unchanged; otherwise validity and error (`tolerance` > 0)
/// include the error of the tilts. Returns what is wrong, or "".
PALPATERESPONSE_EXPORT std::string attachTilts(const TiltRequest& request,
  const BodyMaterial* material, double tolerance, const std::string& name, vtkPolyData* output);
} // namespace palpate

#endif
