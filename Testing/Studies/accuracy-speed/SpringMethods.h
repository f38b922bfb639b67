// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "StudyBody.h"
#include "StudyLaw.h"

#include <memory>
#include <string>
#include <vector>

/// Forces that are proportional to the deflection. What they are calibrated with is a tool of their
/// own, `known`: the force of a point does not know what presses it.
namespace palpate::testing
{
/// One spring for the whole body: the mean of the points' best ones.
std::unique_ptr<ContactMethod> oneSpring(const StudyBody& body, const StudyLaw& known);

/// A spring at each point, the best fit to the exact curve of `known` there: least squares over all
/// depths of its range.
std::unique_ptr<ContactMethod> pointSprings(
  const std::string& name, const StudyBody& body, const StudyLaw& known);

/**
 * The displacement of a fixed patch under a uniform traction, as haptic finite-element works have
 * it: one compliance per point. The patch has the contact radius of `known` at half its range. On a
 * layer: the uniform patch on a half-space, and what a flat punch of that radius yields less there.
 */
std::unique_ptr<ContactMethod> fixedPatch(const StudyBody& body, const StudyLaw& known);
} // namespace palpate::testing
