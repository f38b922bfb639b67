// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/SimplicialFactor.h"

#include <algorithm>

namespace palpate
{
namespace
{
/// Number of loads that share a pass through the columns. It corresponds to a few cache lines per
/// unknown.
constexpr std::size_t BlockSize = 16;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, static_cast<int>(BlockSize), Eigen::RowMajor>;
} // namespace

double SimplicialFactor::Cholesky::predictedNonZeros() const
{
  // The starts of columns are ints, which may overflow. Their unsigned differences are still
  // correct.
  const int* starts = this->m_matrix.outerIndexPtr();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < this->m_matrix.outerSize(); ++i)
  {
    sum += static_cast<unsigned>(starts[i + 1]) - static_cast<unsigned>(starts[i]);
  }
  return sum;
}

bool SimplicialFactor::analyse(const SymmetricSparse& lower)
{
  this->Solver.analyzePattern(lower);
  const double perEntry = sizeof(double) + sizeof(int);
  // The memory is the sum for L, for the permuted copy of K, and for the vectors of the ordering.
  this->Bytes =
    perEntry * (this->Solver.predictedNonZeros() + static_cast<double>(lower.nonZeros())) +
    64.0 * static_cast<double>(lower.rows());
  // The number of entries is checked, because Eigen counts entries in an int.
  return this->Solver.predictedNonZeros() < 2147483647.0;
}

double SimplicialFactor::memoryEstimate() const
{
  return this->Bytes;
}

bool SimplicialFactor::factorise(const SymmetricSparse& lower)
{
  this->Solver.factorize(lower);
  return this->Solver.info() == Eigen::Success;
}

Eigen::VectorXd SimplicialFactor::solve(const Eigen::VectorXd& load) const
{
  return this->Solver.solve(load);
}

Eigen::MatrixXd SimplicialFactor::solveAll(const Eigen::MatrixXd& loads) const
{
  return this->Solver.solve(loads);
}

std::vector<double> SimplicialFactor::compliances(
  const std::vector<SparseLoad>& loads, const WorkObserver& observer) const
{
  const auto& lower = this->Solver.matrixL().nestedExpression();
  const auto& permutation = this->Solver.permutationP().indices();
  const std::vector<int> position(permutation.data(), permutation.data() + permutation.size());
  const std::vector<std::size_t> order = orderLoads(loads, position);
  const int* starts = lower.outerIndexPtr();
  const int* rows = lower.innerIndexPtr();
  const double* values = lower.valuePtr();

  std::vector<double> result(loads.size(), 0.0);
  Rows x = Rows::Zero(lower.rows(), static_cast<int>(BlockSize));
  std::vector<unsigned char> marked(static_cast<std::size_t>(lower.rows()), 0);
  std::vector<int> path;
  for (std::size_t first = 0; first < order.size(); first += BlockSize)
  {
    const std::size_t count = std::min(BlockSize, order.size() - first);
    path.clear();
    for (std::size_t k = 0; k < count; ++k)
    {
      for (const auto& [unknown, force] : loads[order[first + k]])
      {
        int column = position[static_cast<std::size_t>(unknown)];
        x(column, static_cast<Eigen::Index>(k)) += force;
        while (column >= 0 && !marked[static_cast<std::size_t>(column)])
        {
          marked[static_cast<std::size_t>(column)] = 1;
          path.push_back(column);
          const int next = starts[column] + 1; // the diagonal comes first, followed by the parent
          column = next < starts[column + 1] ? rows[next] : -1;
        }
      }
    }
    std::sort(path.begin(), path.end());
    Eigen::Array<double, 1, static_cast<int>(BlockSize)> sum;
    sum.setZero();
    for (const int column : path)
    {
      const Eigen::Array<double, 1, static_cast<int>(BlockSize)> y =
        x.row(column).array() / values[starts[column]];
      sum += y.square();
      for (int i = starts[column] + 1; i < starts[column + 1]; ++i)
      {
        x.row(rows[i]).array() -= values[i] * y;
      }
    }
    for (const int column : path)
    {
      x.row(column).setZero();
      marked[static_cast<std::size_t>(column)] = 0;
    }
    for (std::size_t k = 0; k < count; ++k)
    {
      result[order[first + k]] = sum[static_cast<Eigen::Index>(k)];
    }
    if (!observer(static_cast<double>(first + count) / static_cast<double>(order.size())))
    {
      return {};
    }
  }
  return result;
}
} // namespace palpate
