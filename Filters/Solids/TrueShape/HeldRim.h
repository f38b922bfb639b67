// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HeldRim_h
#define palpate_HeldRim_h

#include "Solids/FiniteElements/ElasticBody.h"
#include "Mechanics/PalpateExport.h"

#include <vector>

namespace palpate
{
/**
 * The edges of a body's surface where what is held of it ends, each with the free triangle beside
 * it: how near a contact may come, at any place of the surface and not at its points alone.
 */
class PALPATE_EXPORT HeldRim
{
public:
  HeldRim() = default; ///< nothing is held
  /// The body must have been taken and assembled; it is not kept.
  explicit HeldRim(const ElasticBody& body);

  /// From a place of the surface with this outward normal to the nearest of them whose triangle
  /// faces the same way, within 40° as all that a contact covers (SurfaceDisc), mm; +inf where
  /// there is none. From any number of threads. Cost: some ns per edge.
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
