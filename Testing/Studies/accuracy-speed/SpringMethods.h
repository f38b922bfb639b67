// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "StudyBody.h"
#include "StudyLaw.h"

#include <memory>
#include <string>
#include <vector>

/// Forces proportional to the deflection. The springs are calibrated with one tool, `known`,
/// because the force of a spring does not depend on the tool.
namespace palpate::testing
{
/// One spring for the whole body: the mean of the best springs of its points.
std::unique_ptr<ContactMethod> oneSpring(const StudyBody& body, const StudyLaw& known);

/// A spring at each point: the least-squares fit to the exact curve of `known` at the point, over
/// all depths of its range.
std::unique_ptr<ContactMethod> pointSprings(
  const std::string& name, const StudyBody& body, const StudyLaw& known);

/**
 * The displacement of a fixed patch under a uniform traction, as in haptic finite-element work: one
 * compliance per point. The patch has the contact radius of `known` at half its range. On a layer
 * it is the uniform patch on a half-space, less the reduction of the deflection by the layer for a
 * flat punch of that radius.
 */
std::unique_ptr<ContactMethod> fixedPatch(const StudyBody& body, const StudyLaw& known);
} // namespace palpate::testing
