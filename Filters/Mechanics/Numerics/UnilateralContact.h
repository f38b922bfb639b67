// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_UnilateralContact_h
#define palpate_UnilateralContact_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// A body that yields under forces on its nodes; its compliance is symmetric and positive definite.
class PALPATE_EXPORT CompliantNodes
{
public:
  virtual ~CompliantNodes() = default;
  /// Computes the forces on the nodes `active` that move these nodes as wanted. The other nodes
  /// carry no force.
  virtual void press(
    const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces) = 0;
  /// Computes the motion of all nodes under forces on the active ones.
  virtual void move(
    const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) = 0;
};

/**
 * Signorini's problem at nodes: forces p ≥ 0 under which every node i moves by at least b_i, and
 * each node that carries a force by exactly b_i.
 *
 * Active sets: the nodes of a guessed contact are pressed to b. Then nodes that pull leave the set,
 * and nodes that were penetrated join it (primal–dual active set, Hintermüller, Ito and Kunisch
 * 2003). All nodes change at once; if the sets do not settle, one node at a time.
 */
class PALPATE_EXPORT UnilateralContact
{
public:
  /// `active` (ascending) is the first guess on input and the nodes in contact on output. Returns
  /// false if the sets did not settle.
  bool solve(CompliantNodes& nodes, const Eigen::VectorXd& wanted, std::vector<int>& active,
    Eigen::VectorXd& forces);
  /// Number of sets that the last solution tried.
  int steps() const { return this->Steps; }

private:
  Eigen::VectorXd Moved;
  std::vector<int> Next;
  std::vector<unsigned char> Touching;
  int Steps = 0;
};
} // namespace palpate

#endif
