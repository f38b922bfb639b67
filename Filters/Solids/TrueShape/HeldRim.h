// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HeldRim_h
#define palpate_HeldRim_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/**
 * The edges of a body's surface where its held part ends, each with the adjacent free triangle.
 * They limit how near a contact may come, at any place of the surface and not only at its points.
 */
class PALPATE_EXPORT HeldRim
{
public:
  HeldRim() = default; ///< no part is held
  /// The body must be taken and assembled; no reference is kept.
  explicit HeldRim(const ElasticBody& body);

  /// Distance from a place of the surface with this outward normal to the nearest edge, mm; +inf
  /// without one. Only edges whose triangle faces the same way count: within 40°, as everywhere
  /// under a contact (SurfaceDisc). Safe from any number of threads. Cost: some ns per edge.
  double distance(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const;

private:
  struct Edge
  {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    Eigen::Vector3d normal; ///< of the free triangle
  };
  std::vector<Edge> Edges;
};
} // namespace palpate

#endif
