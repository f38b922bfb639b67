// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SimplicialFactor_h
#define palpate_SimplicialFactor_h

#include "Solids/FiniteElements/StiffnessFactor.h"

#include <Eigen/SparseCholesky>

namespace palpate
{
/// Eigen's simplicial Cholesky factor. It is computed column by column on one thread.
class SimplicialFactor : public StiffnessFactor
{
public:
  bool analyse(const SymmetricSparse& lower) override;
  double memoryEstimate() const override;
  bool factorise(const SymmetricSparse& lower) override;
  Eigen::VectorXd solve(const Eigen::VectorXd& load) const override;
  Eigen::MatrixXd solveAll(const Eigen::MatrixXd& loads) const override;
  std::vector<double> compliances(
    const std::vector<SparseLoad>& loads, const WorkObserver& observer) const override;

private:
  /// Gives access to the result of the symbolic analysis.
  class Cholesky : public Eigen::SimplicialLLT<SymmetricSparse, Eigen::Lower>
  {
  public:
    double predictedNonZeros() const;
  };

  Cholesky Solver;
  double Bytes = 0.0;
};
} // namespace palpate

#endif
