// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SurfacePatch_h
#define palpate_SurfacePatch_h

#include "Contact/BodyMesh.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace palpate
{
/// Called with the point index; the distance from the contact along the surface, mm; the unit
/// tangent at the point that points away from the contact (zero at the contact itself); and the
/// unit outward normal.
using PatchVisitor =
  std::function<void(std::int32_t, double, const Vector3& away, const Vector3& normal)>;

/**
 * The patch of a surface around a contact. It contains the start points that were added, and all
 * points that are connected to them and have a normal within 60° of the contact normal. If `reach`
 * is positive, a point must also be within that distance (mm), or next to a point within that
 * distance. Start points always belong to the patch.
 *
 * The distance is the length of the circular arc that is tangent to the surface at the contact and
 * at the point: the length of the chord times (θ/2)/sin(θ/2). θ is the angle between the contact
 * normal and the point normal, in the plane of the chord and the contact normal.
 *
 * The mesh may be a piece of the body. Points at a seam then have the normals of the whole body. A
 * point at a seam is also a start point if the patch has reached it on another piece.
 */
class PALPATE_EXPORT SurfacePatch
{
public:
  SurfacePatch(const BodyMesh& mesh, const Vector3& contact, const Vector3& normal, double reach);

  void setNormal(std::int32_t point, const Vector3& normal) { this->Given[point] = normal; }
  void enter(std::int32_t point);
  bool has(std::int32_t point) const { return this->Seen[static_cast<std::size_t>(point)]; }
  /// Returns whether there are start points that have not been visited yet.
  bool isPending() const noexcept { return !this->Front.empty(); }
  /// Visits the start points and all points connected to them, each point once.
  void visit(const PatchVisitor& visitor);

private:
  Vector3 normalAt(std::int32_t point) const;

  const BodyMesh& Mesh;
  Vector3 Contact;
  Vector3 Normal;
  double Reach;
  std::unordered_map<std::int32_t, Vector3> Given;
  std::vector<bool> Seen;
  std::vector<std::int32_t> Front;
};

/// Visits the patch around a contact on a triangle of the whole body. The corners of the triangle
/// always belong to the patch.
PALPATE_EXPORT void visitSurfacePatch(const BodyMesh& mesh, std::int32_t triangle,
  const Vector3& contact, const Vector3& normal, double reach, const PatchVisitor& visitor);
} // namespace palpate

#endif
