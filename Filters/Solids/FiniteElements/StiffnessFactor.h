// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Cholesky factor of a stiffness matrix, P K Pᵀ = L Lᵀ, and the compliances bᵀK⁻¹b of sparse loads.
 *
 * A compliance needs the forward half of the solution alone, bᵀK⁻¹b = |L⁻¹Pb|², and of L only the
 * columns on the paths of the load's unknowns to the root of the elimination tree. Loads are taken
 * in blocks of neighbours in that tree, which share most of their path.
 *
 * Supernodal: CHOLMOD (Chen, Davis, Hager and Rajamanickam 2008), ordered by METIS, its supernodes
 * walked with BLAS. CHOLMOD's own forward solution of blocks of as many loads, which reads all of L
 * each time, takes 2.9 times as long for one load and 6.6 times for the 900 of a face
 * (Testing/Benchmarks/StiffnessFactorBenchmark.cxx). Simplicial: Eigen's, ordered by minimum
 * degree; it needs no other library and is some hundred times slower on large bodies. Both give the
 * same within 1e-9. The same bits for any number of threads, of BLAS too where that is OpenBLAS,
 * which is limited to one meanwhile, as several would sum in another order.
 */
#ifndef palpate_StiffnessFactor_h
#define palpate_StiffnessFactor_h

#include "Mechanics/PalpateExport.h"
#include "Solids/FiniteElements/StiffnessAssembly.h"
#include "Mechanics/SharedWork.h"

#include <functional>
#include <memory>
#include <utility>

namespace palpate
{
/// The unknowns a load acts on, and the forces (N).
using SparseLoad = std::vector<std::pair<int, double>>;

/// A factorised stiffness matrix K, for bᵀK⁻¹b and K⁻¹b.
class PALPATE_EXPORT StiffnessFactor
{
public:
  enum class Kind
  {
    Automatic, ///< Supernodal if this build has CHOLMOD
    Supernodal,
    Simplicial
  };

  /// Null if this build does not have it.
  static std::unique_ptr<StiffnessFactor> make(Kind kind);

  StiffnessFactor() = default;
  StiffnessFactor(const StiffnessFactor&) = delete;
  StiffnessFactor& operator=(const StiffnessFactor&) = delete;
  virtual ~StiffnessFactor() = default;

  /// Chooses the order of elimination. False: not enough memory.
  virtual bool analyse(const SymmetricSparse& lower) = 0;
  /// Peak memory of the factorisation, bytes, known after analyse().
  virtual double memoryEstimate() const = 0;
  /// Computes L of the analysed matrix. False: not positive definite, or not enough memory.
  virtual bool factorise(const SymmetricSparse& lower) = 0;
  /// x = K⁻¹ b.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& load) const = 0;
  /// The same for each column, from any number of threads at once; empty: not enough memory. A
  /// column's bits depend on the number of columns, not of threads.
  virtual Eigen::MatrixXd solveAll(const Eigen::MatrixXd& loads) const = 0;
  /// The compliances of all loads, in their order; empty when the observer stopped it.
  virtual std::vector<double> compliances(
    const std::vector<SparseLoad>& loads, const WorkObserver& observer) const = 0;
};

/// The indices of the loads, ordered by their first unknown in the order of elimination; `position`
/// maps an unknown to its place there. Empty loads are left out.
PALPATE_EXPORT std::vector<std::size_t> orderLoads(
  const std::vector<SparseLoad>& loads, const std::vector<int>& position);
} // namespace palpate

#endif
