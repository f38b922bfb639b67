// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_UnilateralContact_h
#define palpate_UnilateralContact_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// A body that deforms under forces at its nodes. Its compliance matrix is symmetric and positive
/// definite.
class PALPATE_EXPORT CompliantNodes
{
public:
  virtual ~CompliantNodes() = default;
  /// Computes the forces at the nodes `active` that cause the displacements `wanted` of these
  /// nodes. The other nodes carry no force.
  virtual void press(
    const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces) = 0;
  /// Computes the displacements of all nodes under forces at the active nodes.
  virtual void move(
    const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) = 0;
};

/**
 * Solves Signorini's problem at nodes: finds the forces p ≥ 0 under which the displacement of every
 * node i is at least b_i, and exactly b_i at each node with a force.
 *
 * Active-set method: the nodes of an assumed contact are displaced by b. Then nodes with tensile
 * forces leave the set, and penetrated nodes join it (primal–dual active set, Hintermüller, Ito and
 * Kunisch 2003). All these nodes change in one step. If the sets do not converge, they change by
 * one node per step.
 */
class PALPATE_EXPORT UnilateralContact
{
public:
  /// `active` (ascending) contains the first guess on input and the nodes in contact on output.
  /// Returns false if the sets did not converge.
  bool solve(CompliantNodes& nodes, const Eigen::VectorXd& wanted, std::vector<int>& active,
    Eigen::VectorXd& forces);
  /// Number of active sets that the last solution has tried.
  int steps() const { return this->Steps; }

private:
  Eigen::VectorXd Moved;
  std::vector<int> Next;
  std::vector<unsigned char> Touching;
  int Steps = 0;
};
} // namespace palpate

#endif
