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
 * contact at any place of the surface, also between its points, must keep a distance from these
 * edges.
 */
class PALPATE_EXPORT HeldRim
{
public:
  HeldRim() = default; ///< no part is held
  /// The body must be assembled. The object keeps no reference to it.
  explicit HeldRim(const ElasticBody& body);

  /// Distance from a place of the surface with this outward normal to the nearest edge, mm; +inf if
  /// there is no edge. Only edges are used whose triangle faces the same way, within 40°, the limit
  /// under a contact (SurfaceDisc). Safe from any number of threads. Cost: a few ns per edge.
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
