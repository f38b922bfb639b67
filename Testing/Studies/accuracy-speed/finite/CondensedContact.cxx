// SPDX-License-Identifier: BSD-3-Clause
#include "CondensedContact.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace palpate::testing
{

CondensedContact::CondensedContact(FiniteBodyPointer body, ToolPointer tool)
  : NodalContact(std::move(body), std::move(tool))
  , Matrix(this->body().compliance())
{
}

std::string CondensedContact::name() const
{
  return "condensed finite elements";
}

std::size_t CondensedContact::bytes() const
{
  return sizeof(double) *
    (static_cast<std::size_t>(this->Matrix.size()) + this->body().globalCompliances().size());
}

void CondensedContact::press(
  const std::vector<int>& active, const Eigen::VectorXd& wanted, Eigen::VectorXd& forces)
{
  const auto count = static_cast<Eigen::Index>(active.size());
  this->Dense.resize(std::max(this->Dense.size(), active.size() * active.size()));
  this->Right.resize(std::max(this->Right.size(), active.size()));
  Eigen::Map<Eigen::MatrixXd> dense(this->Dense.data(), count, count);
  Eigen::Map<Eigen::VectorXd> right(this->Right.data(), count);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    const int node =
      this->candidates()[static_cast<std::size_t>(active[static_cast<std::size_t>(j)])];
    const double* column = this->Matrix.data() + node * this->Matrix.rows();
    for (Eigen::Index i = j; i < count; ++i)
    {
      dense(i, j) =
        column[this->candidates()[static_cast<std::size_t>(active[static_cast<std::size_t>(i)])]];
    }
    right[j] = wanted[active[static_cast<std::size_t>(j)]];
  }
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(dense);
  factor.solveInPlace(right);
  forces.setZero();
  for (Eigen::Index j = 0; j < count; ++j)
  {
    forces[active[static_cast<std::size_t>(j)]] = right[j];
  }
}

void CondensedContact::move(
  const std::vector<int>& active, const Eigen::VectorXd& forces, Eigen::VectorXd& moved)
{
  const std::vector<int>& nodes = this->candidates();
  moved.setZero(static_cast<Eigen::Index>(nodes.size()));
  for (const int j : active)
  {
    const double* column =
      this->Matrix.data() + nodes[static_cast<std::size_t>(j)] * this->Matrix.rows();
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      moved[static_cast<Eigen::Index>(i)] += column[nodes[i]] * forces[j];
    }
  }
}

} // namespace palpate::testing
