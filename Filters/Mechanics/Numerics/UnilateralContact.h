// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_UnilateralContact_h
#define palpate_UnilateralContact_h

#include "Mechanics/PalpateExport.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/// What yields under forces on its nodes; symmetric, positive definite.
class PALPATE_EXPORT CompliantNodes
{
public:
  virtual ~CompliantNodes() = default;
  /// The forces on the nodes `active` (the others carry none) under which these move as wanted.
  virtual void press(
    const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces) = 0;
  /// How all nodes move under forces on the active ones.
  virtual void move(
    const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) = 0;
};

/**
 * Signorini's problem at nodes: forces p ≥ 0 with which every node i moves by at least b_i, those
 * that carry force by exactly b_i.
 *
 * Active sets: the nodes in contact are guessed, pressed to b, those that pull are let go, those
 * passed through are taken in (primal–dual active set, Hintermüller, Ito and Kunisch 2003), all at
 * once; should the sets not settle, one at a time.
 */
class PALPATE_EXPORT UnilateralContact
{
public:
  /// `active`, ascending, is the first guess and then the nodes in contact. False if it did not
  /// settle.
  bool solve(CompliantNodes& nodes, const Eigen::VectorXd& wanted, std::vector<int>& active,
    Eigen::VectorXd& forces);
  /// How many sets the last solution tried.
  int steps() const { return this->Steps; }

private:
  Eigen::VectorXd Moved;
  std::vector<int> Next;
  std::vector<unsigned char> Touching;
  int Steps = 0;
};
} // namespace palpate

#endif
