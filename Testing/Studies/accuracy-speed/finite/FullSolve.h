// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "NodalContact.h"

namespace palpate::testing
{

/// The contact with the whole factorised body. The forces of the nodes in contact come from
/// conjugate gradients; each step solves the whole body. No compliance of the window is stored.
class FullSolve : public NodalContact
{
public:
  FullSolve(FiniteBodyPointer body, ToolPointer tool)
    : NodalContact(std::move(body), std::move(tool))
  {
  }

  std::string name() const override { return "full finite elements (offline)"; }
  std::size_t bytes() const override { return this->body().factorBytes(); }
  /// Number of solutions of the whole body so far.
  int solutions() const { return this->Solutions; }

private:
  void press(const std::vector<int>& active, const Eigen::VectorXd& wanted,
    Eigen::VectorXd& forces) override;
  void move(
    const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved) override;

  int Solutions = 0;
};

} // namespace palpate::testing
