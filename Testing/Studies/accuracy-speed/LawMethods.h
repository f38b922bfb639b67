// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ContactMethod.h"
#include "StudyBody.h"
#include "StudyLaw.h"

#include <functional>
#include <memory>

/// Laws evaluated in the tick with the data of the three points under the contact.
namespace palpate::testing
{
/// Table 1 of Mahvash and Hayward on a half-space of the point's modulus: paraboloid (in place of
/// the sphere), flat, cone. Null for other tools.
std::unique_ptr<ContactMethod> tableOne(const StudyBody& body, const StudyLaw& law);

/// The exact law, solved in the tick: half-space, or the integral equation of the layer. The global
/// compliance of the body is not included.
std::unique_ptr<ContactMethod> exactLaw(const StudyBody& body, const StudyLaw& law);

/// The best reference of a scene without finite elements. It evaluates StudyLaw with the Spot under
/// the contact point. The contact point is on the smooth surface through the points and is followed
/// as in ContactTracker. On a plane this surface is the plane itself.
std::unique_ptr<ContactMethod> exactReference(const StudyBody& body, const StudyLaw& law);

/// The same reference without a mesh: the law of a half-space on a ball of this radius about the
/// origin.
std::unique_ptr<ContactMethod> ballReference(double radius, const StudyLaw& law);
/// The same reference on the plane z = 0, with a Spot for each place (x, y).
using SpotMap = std::function<Spot(double x, double y)>;
std::unique_ptr<ContactMethod> planeReference(SpotMap spotAt, const StudyLaw& law);
} // namespace palpate::testing
