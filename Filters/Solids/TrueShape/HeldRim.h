// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HeldRim_h
#define palpate_HeldRim_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/**
 * The edges of a body's surface where its held part ends, each with the adjacent free triangle. A
 * contact anywhere on the surface must not reach these edges.
 */
class PALPATE_EXPORT HeldRim
{
public:
  HeldRim() = default; ///< Creates an object for a body without a held part.
  /// The body must be assembled. The object keeps no reference to it.
  explicit HeldRim(const ElasticBody& body);

  /// Returns the distance from a position on the surface to the nearest edge, mm; +inf if there is
  /// no edge. `normal` is the outward normal at the position. Only edges are used whose free
  /// triangle has a normal within 40° of `normal`, which is the limit under a contact
  /// (SurfaceDisc). Thread-safe. Cost: a few ns per edge.
  double distance(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

private:
  struct Edge
  {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    Eigen::Vector3d normal; ///< normal of the free triangle
  };
  std::vector<Edge> Edges;
};
} // namespace palpate

#endif
