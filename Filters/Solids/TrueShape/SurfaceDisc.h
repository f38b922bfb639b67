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
/// cos 40°: how far the surface may turn under a contact: less than the normals at the edge of a
/// block do. At its own middle it may turn by less (PatchTurn), as a contact on an edge has no
/// normal.
constexpr double ContactTurn = 0.76604444311897803520;

/// A surface point near another one, seen in the tangent plane there.
struct DiscPoint
{
  std::int32_t point = 0;
  Eigen::Vector2d at;    ///< mm
  double drop = 0.0;     ///< how far it lies below that plane, mm (SmoothSurface)
  double area = 0.0;     ///< a third of its triangles', mm²
  double distance = 0.0; ///< |at|
};

/**
 * The points of the surface around a point X, up to a radius and as far as the surface is fit for a
 * contact: connected to X without a triangle that turns by more than 40° from the normal at X (30°
 * at X itself), free to move along their normal, and of the material of X: E within 5 %, ν within
 * 0.01 of the mean of the elements at X.
 *
 * `status` says what is wrong with X itself; `limit` how far from X the first edge, held point or
 * other material lies, and `limitedBy` which it is.
 */
struct SurfaceDisc
{
  PatchStatus status = PatchStatus::Valid;
  std::vector<DiscPoint> points; ///< X first, then by distance
  double limit = Infinity;       ///< mm
  PatchStatus limitedBy = PatchStatus::Valid;
};

/// X is a point of the surface of a body that was taken and assembled.
PALPATE_EXPORT SurfaceDisc surfaceDisc(const ElasticBody& body, std::int32_t point, double radius);

/// Whether there is no border between two materials: E within 5 % of the second's, ν within 0.01.
/// Graded ones, and those of images, have none.
bool isNearlyAlike(const ElasticMaterial& other, const ElasticMaterial& material);

/// Whether the elements at a surface point are of one material, as nearly as a disc asks for.
PALPATE_EXPORT bool isOfOneMaterial(const ElasticBody& body, std::int32_t point);

/// Why a point cannot be pressed, in words; "" if it can.
PALPATE_EXPORT std::string whyNotPressed(const ElasticBody& body, std::int32_t point);
} // namespace palpate

#endif
