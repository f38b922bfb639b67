// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "StudyBody.h"
#include "StudyLaw.h"

#include <memory>
#include <vector>

namespace palpate::testing
{
/// A method that may be told how the tool leans, from then on: by an angle (rad) towards +x. The
/// tip that it is asked about lies on the tool's axis, above or under the plane z = 0.
class TiltMethod : public ContactMethod
{
public:
  virtual void lean(double angle) = 0;
};
using TiltMethodList = std::vector<std::unique_ptr<TiltMethod>>;

constexpr double LargestTilt = 25.0 / 180.0 * 3.14159265358979323846; ///< of the study, rad

/// Those whose force is asked for, of a tool on a half-space: without a tilt, its tip or its
/// deepest point as deep; the table in the tick; circles; boundary elements.
TiltMethodList tiltMethods(const StudyTool& tool);

/// The same tick on the same body, for its time: without an axis, upright, leaning; and on a layer
/// whose thickness varies, so that each point has weights of its own among several laws.
TiltMethodList tiltTicks(const StudyTool& tool);
} // namespace palpate::testing
