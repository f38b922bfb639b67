// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "NodalContact.h"

namespace palpate::testing
{

/// The contact with the stored compliance of the window's nodes. Each trial set of nodes in contact
/// is solved by a dense factorisation.
class CondensedContact : public NodalContact
{
public:
  CondensedContact(FiniteBodyPointer body, ToolPointer tool);

  std::string name() const override;
  /// Bytes of the compliance matrix of the window and of the compliances of the first guess.
  std::size_t bytes() const override;

private:
  void press(const std::vector<int>& active, const Eigen::VectorXd& wanted,
    Eigen::VectorXd& forces) override;
  void move(
    const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) override;

  const Eigen::MatrixXd& Matrix;
  std::vector<double> Dense; // matrix of the active nodes; grows to the largest contact so far
  std::vector<double> Right;
};

} // namespace palpate::testing
