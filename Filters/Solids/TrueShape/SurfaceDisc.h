// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfaceDisc_h
#define palpate_SurfaceDisc_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Solids/FiniteElements/PatchCompliance.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/PalpateExport.h"

#include <string>

namespace palpate
{
/// cos 40°, for the largest variation of the surface normal under a contact. This angle is smaller
/// than the variation at the edge of a block. At the middle of the contact the limit is smaller
/// (PatchTurn), because a contact on an edge has no normal.
constexpr double ContactTurn = 0.76604444311897803520;

/// A surface point near the middle point of a disc, in the coordinates of the tangent plane at the
/// middle point.
struct DiscPoint
{
  std::int32_t point = 0;
  Eigen::Vector2d at;    ///< position in the tangent plane, mm
  double drop = 0.0;     ///< distance of the point below the tangent plane, mm (SmoothSurface)
  double area = 0.0;     ///< a third of the area of the triangles around the point, mm²
  double distance = 0.0; ///< distance from the middle point, |at|, mm
};

/**
 * The surface points around a point X, up to a radius, that can be under one contact with X. These
 * points satisfy three conditions: they are connected to X by triangles whose normals are within
 * 40° of the normal at X (30° at X itself); they are free to move along their normals; and their
 * material is nearly that of X: E differs by at most 5 % and ν by at most 0.01 from the mean of the
 * elements at X.
 *
 * `status` is the reason why X itself cannot be pressed, or Valid. `limit` is the distance from X
 * to the first edge, held point or other material. `limitedBy` is the kind of the limit.
 */
struct SurfaceDisc
{
  PatchStatus status = PatchStatus::Valid;
  std::vector<DiscPoint> points; ///< X first, the other points sorted by distance
  double limit = Infinity;       ///< distance to the limit, mm
  PatchStatus limitedBy = PatchStatus::Valid;
};

/// Returns the disc of a point. `body` must be assembled. `point` is a point of its surface.
PALPATE_EXPORT SurfaceDisc surfaceDisc(const ElasticBody& body, std::int32_t point, double radius);

/// Returns whether the border between elements of two materials is neglected. It is if E differs by
/// at most 5 % of the E of `material`, and ν by at most 0.01. Therefore graded bodies and bodies
/// from images have no borders.
bool isNearlyAlike(const ElasticMaterial& other, const ElasticMaterial& material);

/// Returns whether the elements at a surface point are of one material, within the tolerances of
/// isNearlyAlike().
PALPATE_EXPORT bool isOfOneMaterial(const ElasticBody& body, std::int32_t point);

/// Returns the reason why a point cannot be pressed; "" if it can be pressed.
PALPATE_EXPORT std::string whyNotPressed(const ElasticBody& body, std::int32_t point);
} // namespace palpate

#endif
