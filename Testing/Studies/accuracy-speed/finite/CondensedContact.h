// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "NodalContact.h"

namespace palpate::testing
{

/// The contact on the stored compliance of the window's nodes: a dense factor of the nodes in
/// contact for each set that is tried.
class CondensedContact : public NodalContact
{
public:
  CondensedContact(FiniteBodyPointer body, ToolPointer tool);

  std::string name() const override;
  /// The matrix of the window, and the compliances of the first guess.
  std::size_t bytes() const override;

private:
  void press(const std::vector<int>& active, const Eigen::VectorXd& wanted,
    Eigen::VectorXd& forces) override;
  void move(
    const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) override;

  const Eigen::MatrixXd& Matrix;
  std::vector<double> Dense; // of the active nodes; grows to the largest contact met
  std::vector<double> Right;
};

} // namespace palpate::testing
