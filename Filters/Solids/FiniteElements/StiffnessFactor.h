// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Cholesky factor of a stiffness matrix, P K Pᵀ = L Lᵀ, and the compliances bᵀK⁻¹b of sparse loads.
 *
 * A compliance needs only the forward half of the solution, bᵀK⁻¹b = |L⁻¹Pb|², and only the columns
 * of L on the paths from the load's unknowns to the root of the elimination tree. Loads are
 * processed in blocks. The loads of a block are neighbours in the elimination tree and share most
 * of their paths.
 *
 * Supernodal: the factor of CHOLMOD (Chen, Davis, Hager and Rajamanickam 2008), ordered by METIS.
 * Its supernodes are processed with BLAS. CHOLMOD's own forward solution is not used, because it
 * reads all of L for each block of loads. With blocks of the same size, it takes 2.9 times as long
 * for one load and 6.6 times as long for the 900 loads of a face
 * (Testing/Benchmarks/StiffnessFactorBenchmark.cxx). Simplicial: Eigen's factor, ordered by minimum
 * degree. It needs no other library and is about a hundred times slower on large bodies. The
 * results of both factors agree within 1e-9. The results are bit-identical for any number of
 * threads. If BLAS is OpenBLAS, it is limited to one thread during the work, because several
 * threads would sum in another order.
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
/// The unknowns on which a load acts, and the forces (N).
using SparseLoad = std::vector<std::pair<int, double>>;

/// A factorised stiffness matrix K, for bᵀK⁻¹b and K⁻¹b.
class PALPATE_EXPORT StiffnessFactor
{
public:
  enum class Kind
  {
    Automatic, ///< selects Supernodal if this build has CHOLMOD, else Simplicial
    Supernodal,
    Simplicial
  };

  /// Creates a factor. Returns null if this build does not have this kind of factor.
  static std::unique_ptr<StiffnessFactor> make(Kind kind);

  StiffnessFactor() = default;
  StiffnessFactor(const StiffnessFactor&) = delete;
  StiffnessFactor& operator=(const StiffnessFactor&) = delete;
  virtual ~StiffnessFactor() = default;

  /// Chooses the order of elimination. Returns false if there is not enough memory.
  virtual bool analyse(const SymmetricSparse& lower) = 0;
  /// Returns the peak memory of the factorisation, bytes. It is known after analyse().
  virtual double memoryEstimate() const = 0;
  /// Computes L of the analysed matrix. Returns false if the matrix is not positive definite, or if
  /// there is not enough memory.
  virtual bool factorise(const SymmetricSparse& lower) = 0;
  /// Returns x = K⁻¹ b.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& load) const = 0;
  /// Returns x = K⁻¹ b for each column. The result is empty if there is not enough memory.
  /// Thread-safe. The rounding of a column depends on the number of columns but not on the number
  /// of threads.
  virtual Eigen::MatrixXd solveAll(const Eigen::MatrixXd& loads) const = 0;
  /// Returns the compliances of all loads, in their order. The result is empty if the observer
  /// stopped the work.
  virtual std::vector<double> compliances(
    const std::vector<SparseLoad>& loads, const WorkObserver& observer) const = 0;
};

/// Returns the indices of the loads, sorted by the first unknown of each load in the order of
/// elimination. `position` maps an unknown to its index in this order. Empty loads are left out.
PALPATE_EXPORT std::vector<std::size_t> orderLoads(
  const std::vector<SparseLoad>& loads, const std::vector<int>& position);
} // namespace palpate

#endif
