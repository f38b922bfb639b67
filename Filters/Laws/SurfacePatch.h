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
/// Point index; distance from the contact along the surface, mm; unit tangent there, away from the
/// contact (zero at the contact itself); unit outward normal.
using PatchVisitor =
  std::function<void(std::int32_t, double, const Vector3& away, const Vector3& normal)>;

/**
 * The patch of a surface around a contact: all that is connected to the points entered first, as
 * far as the point normal lies within 60° of the contact normal and, if `reach` > 0, the point
 * within that distance (mm) or next to a point that is. Entered points always belong to it.
 *
 * The distance is that of the circular arc that leaves the contact and arrives at the point along
 * the surface: chord (θ/2)/sin(θ/2), θ the angle between the contact normal and the point normal
 * seen in the plane of chord and contact normal.
 *
 * The mesh may be a piece: its points at a seam then get the normals of the whole, and are entered
 * when they were entered on another piece.
 */
class PALPATE_EXPORT SurfacePatch
{
public:
  SurfacePatch(const BodyMesh& mesh, const Vector3& contact, const Vector3& normal, double reach);

  void setNormal(std::int32_t point, const Vector3& normal) { this->Given[point] = normal; }
  void enter(std::int32_t point);
  bool has(std::int32_t point) const { return this->Seen[static_cast<std::size_t>(point)]; }
  /// Whether points wait to be visited.
  bool isPending() const noexcept { return !this->Front.empty(); }
  /// Visits the points entered and all connected to them, each once.
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

/// Visits the patch around a contact on a triangle of the whole body: always its corners.
PALPATE_EXPORT void visitSurfacePatch(const BodyMesh& mesh, std::int32_t triangle,
  const Vector3& contact, const Vector3& normal, double reach, const PatchVisitor& visitor);
} // namespace palpate

#endif
