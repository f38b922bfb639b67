// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "StudyBody.h"
#include "StudyLaw.h"

#include <memory>
#include <vector>

namespace palpate::testing
{
/// A method with a tilt of the tool. The angle (rad) is towards +x and is valid until it is set
/// again. The tip is a point on the tool's axis, above or below the plane z = 0.
class TiltMethod : public ContactMethod
{
public:
  virtual void lean(double angle) = 0;
};
using TiltMethodList = std::vector<std::unique_ptr<TiltMethod>>;

constexpr double LargestTilt = 25.0 / 180.0 * 3.14159265358979323846; ///< of the study, rad

/// Methods whose force is evaluated, for a tool on a half-space: an upright tool at the depth of
/// the tip or of the deepest point; the table in the tick; circles; boundary elements.
TiltMethodList tiltMethods(const StudyTool& tool);

/// The tick on one body, to compare its times: without an axis, upright, and tilted; also on a
/// layer whose thickness varies, so that each point has separate weights of several laws.
TiltMethodList tiltTicks(const StudyTool& tool);
} // namespace palpate::testing
