// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "StudyBody.h"
#include "StudyLaw.h"

#include <functional>
#include <memory>

/// Laws evaluated in the tick, with what is known of the three points under the contact.
namespace palpate::testing
{
/// Table 1 of Mahvash and Hayward: paraboloid for sphere, flat, cone, on a half-space of the
/// point's modulus. Null for other tools.
std::unique_ptr<ContactMethod> tableOne(const StudyBody& body, const StudyLaw& law);

/// The exact law: half-space, or the integral equation of the layer, solved in the tick. Without
/// the compliance of the body as a whole.
std::unique_ptr<ContactMethod> exactLaw(const StudyBody& body, const StudyLaw& law);

/// The best reference of a scene without finite elements: StudyLaw with what lies under the contact
/// point, on the smooth surface through the points, followed as ContactTracker does. On a plane
/// that is the plane itself.
std::unique_ptr<ContactMethod> exactReference(const StudyBody& body, const StudyLaw& law);

/// The same without a mesh: a half-space's law on a ball of this radius about the origin.
std::unique_ptr<ContactMethod> ballReference(double radius, const StudyLaw& law);
/// And on the plane z = 0, with what lies under a place (x, y).
using SpotMap = std::function<Spot(double x, double y)>;
std::unique_ptr<ContactMethod> planeReference(SpotMap spotAt, const StudyLaw& law);
} // namespace palpate::testing
