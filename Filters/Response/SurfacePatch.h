// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfacePatch_h
#define SurfacePatch_h

#include "BodyMesh.h"

#include <cstdint>
#include <functional>

namespace palpate
{
/// Point index; distance from the contact along the surface, mm; unit tangent there, away from the
/// contact (zero at the contact itself).
using PatchVisitor = std::function<void(std::int32_t, double, const Vector3&)>;

/**
 * Visits each point of the patch around a contact: connected to `triangle` within the patch, with a
 * point normal within 60° of the contact normal and, if `reach` > 0, within that distance (mm)
 * or next to a point that is.
 * Always the corners of the triangle itself.
 *
 * The distance is that of the circular arc that leaves the contact and arrives at the point along
 * the surface: chord (θ/2)/sin(θ/2), θ the angle between the contact normal and the point normal
 * seen in the plane of chord and contact normal.
 */
void visitSurfacePatch(const BodyMesh& mesh, std::int32_t triangle, const Vector3& contact,
  const Vector3& normal, double reach, const PatchVisitor& visit);
} // namespace palpate

#endif
