// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/SupernodalFactor.h"

#ifndef PALPATE_WITH_CHOLMOD

namespace palpate
{
std::unique_ptr<StiffnessFactor> makeSupernodalFactor()
{
  return nullptr;
}
} // namespace palpate

#else

#include "Solids/FiniteElements/SingleThread.h"
#include "Mechanics/SharedWork.h"

#include <cholmod.h>

#include <algorithm>
#include <mutex>

// Functions of BLAS: B := L⁻¹ B and C := α A B + β C.
extern "C"
{
  void dtrsm_(const char* side, const char* upper, const char* transposed, const char* unit,
    const int* m, const int* n, const double* alpha, const double* a, const int* lda, double* b,
    const int* ldb);
  void dgemm_(const char* transposedA, const char* transposedB, const int* m, const int* n,
    const int* k, const double* alpha, const double* a, const int* lda, const double* b,
    const int* ldb, const double* beta, double* c, const int* ldc);
}

namespace palpate
{
namespace
{
/// Number of right-hand sides per block. It was chosen by measurements on a body of 95 000 unknowns
/// (StiffnessFactorBenchmark.cxx).
constexpr std::size_t SupernodalBlock = 64;

/// L by supernodes, in CHOLMOD's storage. The columns super[s] to super[s+1] - 1 share the rows
/// rows[pi[s]] to rows[pi[s+1] - 1]. The first of these rows are the columns themselves. Each
/// supernode is dense and stored column by column.
struct Supernodes
{
  explicit Supernodes(const cholmod_factor* factor)
    : count(static_cast<int>(factor->nsuper))
    , super(static_cast<const int*>(factor->super))
    , pi(static_cast<const int*>(factor->pi))
    , px(static_cast<const int*>(factor->px))
    , rows(static_cast<const int*>(factor->s))
    , values(static_cast<const double*>(factor->x))
    , ofColumn(factor->n)
  {
    for (int s = 0; s < this->count; ++s)
    {
      std::fill(
        this->ofColumn.begin() + this->super[s], this->ofColumn.begin() + this->super[s + 1], s);
    }
  }

  int columns(int s) const { return this->super[s + 1] - this->super[s]; }
  int rowTotal(int s) const { return this->pi[s + 1] - this->pi[s]; }
  int supernodeOf(int column) const { return this->ofColumn[static_cast<std::size_t>(column)]; }
  /// Returns the next supernode towards the root, or -1.
  int parent(int s) const
  {
    return this->rowTotal(s) > this->columns(s)
      ? this->supernodeOf(this->rows[this->pi[s] + this->columns(s)])
      : -1;
  }

  int count;
  const int* super;
  const int* pi;
  const int* px;
  const int* rows;
  const double* values;
  std::vector<int> ofColumn;
};

/// Computes the forward solution of one block of loads, along the union of the paths of these loads
/// to the root.
class PathSolver
{
public:
  explicit PathSolver(const Supernodes& supernodes)
    : Tree(supernodes)
    , Offset(static_cast<std::size_t>(supernodes.count), -1)
  {
  }

  /// Adds |L⁻¹P b|² of load order[k] to result[order[k]], k = first .. first + count.
  void run(const std::vector<SparseLoad>& loads, const std::vector<int>& position,
    const std::size_t* order, std::size_t count, std::vector<double>& result)
  {
    this->findPath(loads, position, order, count);
    for (std::size_t k = 0; k < count; ++k)
    {
      for (const auto& [unknown, force] : loads[order[k]])
      {
        const int row = position[static_cast<std::size_t>(unknown)];
        const int s = this->Tree.supernodeOf(row);
        this->X[this->start(s, count) + static_cast<std::size_t>(row - this->Tree.super[s]) +
          k * static_cast<std::size_t>(this->Tree.columns(s))] += force;
      }
    }
    for (const int s : this->Path)
    {
      this->eliminate(s, count);
      const double* x = this->X.data() + this->start(s, count);
      for (std::size_t k = 0; k < count; ++k)
      {
        const auto n = this->Tree.columns(s);
        result[order[k]] +=
          Eigen::Map<const Eigen::VectorXd>(x + k * static_cast<std::size_t>(n), n).squaredNorm();
      }
    }
    for (const int s : this->Path)
    {
      this->Offset[static_cast<std::size_t>(s)] = -1;
    }
  }

private:
  /// Returns the start in X of the block of supernode s. The block is columns(s) × count and stored
  /// column by column.
  std::size_t start(int s, std::size_t count) const
  {
    return static_cast<std::size_t>(this->Offset[static_cast<std::size_t>(s)]) * count;
  }

  void findPath(const std::vector<SparseLoad>& loads, const std::vector<int>& position,
    const std::size_t* order, std::size_t count)
  {
    this->Path.clear();
    for (std::size_t k = 0; k < count; ++k)
    {
      for (const auto& entry : loads[order[k]])
      {
        int s = this->Tree.supernodeOf(position[static_cast<std::size_t>(entry.first)]);
        while (s >= 0 && this->Offset[static_cast<std::size_t>(s)] < 0)
        {
          this->Offset[static_cast<std::size_t>(s)] = 0;
          this->Path.push_back(s);
          s = this->Tree.parent(s);
        }
      }
    }
    // After sorting, a parent comes after its children.
    std::sort(this->Path.begin(), this->Path.end());
    int offset = 0;
    for (const int s : this->Path)
    {
      this->Offset[static_cast<std::size_t>(s)] = offset;
      offset += this->Tree.columns(s);
    }
    this->X.assign(static_cast<std::size_t>(offset) * count, 0.0);
  }

  void eliminate(int s, std::size_t count)
  {
    const int n = this->Tree.columns(s);
    const int m = this->Tree.rowTotal(s);
    const int below = m - n;
    const int right = static_cast<int>(count);
    const double one = 1.0;
    const double zero = 0.0;
    const double* l = this->Tree.values + this->Tree.px[s];
    double* x = this->X.data() + this->start(s, count);
    dtrsm_("L", "L", "N", "N", &n, &right, &one, l, &m, x, &n);
    if (below == 0)
    {
      return;
    }
    this->Update.resize(static_cast<std::size_t>(below) * count);
    dgemm_(
      "N", "N", &below, &right, &n, &one, l + n, &m, x, &n, &zero, this->Update.data(), &below);
    const int* rows = this->Tree.rows + this->Tree.pi[s] + n;
    for (int i = 0; i < below;)
    {
      // The rows of one ancestor are contiguous.
      const int a = this->Tree.supernodeOf(rows[i]);
      const int end = this->Tree.super[a + 1];
      int last = i;
      while (last < below && rows[last] < end)
      {
        ++last;
      }
      double* target = this->X.data() + this->start(a, count);
      const int base = this->Tree.super[a];
      const int height = this->Tree.columns(a);
      for (int k = 0; k < right; ++k)
      {
        double* to = target + static_cast<std::ptrdiff_t>(k) * height - base;
        const double* from = this->Update.data() + static_cast<std::ptrdiff_t>(k) * below;
        for (int j = i; j < last; ++j)
        {
          to[rows[j]] -= from[j];
        }
      }
      i = last;
    }
  }

  const Supernodes& Tree;
  std::vector<int> Offset;
  std::vector<int> Path;
  std::vector<double> X;
  std::vector<double> Update;
};

class SupernodalFactor : public StiffnessFactor
{
public:
  SupernodalFactor()
  {
    cholmod_start(&this->Common);
    this->Common.print = 0;
    this->Common.supernodal = CHOLMOD_SUPERNODAL;
    this->Common.final_ll = 1;
    this->Common.nmethods = 1;
    this->Common.method[0].ordering = CHOLMOD_METIS;
    this->Common.postorder = 1;
    this->Common.quick_return_if_not_posdef = 1;
  }
  ~SupernodalFactor() override
  {
    cholmod_free_factor(&this->Factor, &this->Common);
    cholmod_finish(&this->Common);
  }

  bool analyse(const SymmetricSparse& lower) override
  {
    cholmod_free_factor(&this->Factor, &this->Common);
    // METIS seeds and uses rand() of the C library. Two simultaneous orderings would share one
    // sequence of random numbers, and rounding would differ from run to run. Therefore only one
    // ordering runs at a time.
    static std::mutex ordering;
    const std::lock_guard<std::mutex> lock(ordering);
    cholmod_sparse matrix = view(lower);
    this->Factor = cholmod_analyze(&matrix, &this->Common);
    if (this->Factor == nullptr && this->Common.status == CHOLMOD_NOT_INSTALLED)
    {
      this->Common.method[0].ordering = CHOLMOD_AMD; // used because this SuiteSparse has no METIS
      this->Factor = cholmod_analyze(&matrix, &this->Common);
    }
    if (this->Factor == nullptr)
    {
      return false;
    }
    // The memory is the sum for L, for its pattern, for the permuted copy of K, and for the largest
    // front.
    this->Bytes = 8.0 * static_cast<double>(this->Factor->xsize) +
      4.0 * static_cast<double>(this->Factor->ssize) +
      12.0 * static_cast<double>(lower.nonZeros()) +
      8.0 * static_cast<double>(this->Factor->maxcsize) + 64.0 * static_cast<double>(lower.rows());
    return true;
  }

  double memoryEstimate() const override { return this->Bytes; }

  bool factorise(const SymmetricSparse& lower) override
  {
    const SingleThread single;
    cholmod_sparse matrix = view(lower);
    return cholmod_factorize(&matrix, this->Factor, &this->Common) != 0 &&
      this->Common.status == CHOLMOD_OK && this->Factor->minor == this->Factor->n;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& load) const override
  {
    const Eigen::MatrixXd x = this->solveAll(load);
    return x.size() > 0 ? Eigen::VectorXd(x.col(0)) : Eigen::VectorXd();
  }

  Eigen::MatrixXd solveAll(const Eigen::MatrixXd& loads) const override
  {
    const SingleThread single;
    cholmod_common common; // workspace of this thread; several threads only read the factor
    cholmod_start(&common);
    common.print = 0;
    cholmod_dense right{};
    right.nrow = right.d = static_cast<std::size_t>(loads.rows());
    right.ncol = static_cast<std::size_t>(loads.cols());
    right.nzmax = right.nrow * right.ncol;
    // The cast is safe, because CHOLMOD only reads the loads.
    right.x = const_cast<double*>(loads.data());
    right.xtype = CHOLMOD_REAL;
    Eigen::MatrixXd x;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, this->Factor, &right, &common);
    if (solution != nullptr)
    {
      x = Eigen::Map<const Eigen::MatrixXd>(
        static_cast<const double*>(solution->x), loads.rows(), loads.cols());
      cholmod_free_dense(&solution, &common);
    }
    cholmod_finish(&common);
    return x;
  }

  std::vector<double> compliances(
    const std::vector<SparseLoad>& loads, const WorkObserver& observer) const override
  {
    const int* permutation = static_cast<const int*>(this->Factor->Perm);
    std::vector<int> position(this->Factor->n);
    for (std::size_t i = 0; i < position.size(); ++i)
    {
      position[static_cast<std::size_t>(permutation[i])] = static_cast<int>(i);
    }
    const std::vector<std::size_t> order = orderLoads(loads, position);
    const Supernodes supernodes(this->Factor);
    const SingleThread single;
    std::vector<double> result(loads.size(), 0.0);
    const std::size_t blocks = (order.size() + SupernodalBlock - 1) / SupernodalBlock;
    // The blocks do not depend on the number of threads. Therefore the results do not depend on it
    // either.
    const auto solveBlock = [&, solver = PathSolver(supernodes)](std::size_t block) mutable
    {
      const std::size_t first = block * SupernodalBlock;
      const std::size_t count = std::min(SupernodalBlock, order.size() - first);
      solver.run(loads, position, order.data() + first, count, result);
    };
    if (!shareWork(blocks, solveBlock, observer))
    {
      return {};
    }
    return result;
  }

private:
  static cholmod_sparse view(const SymmetricSparse& lower)
  {
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = static_cast<std::size_t>(lower.rows());
    matrix.nzmax = static_cast<std::size_t>(lower.nonZeros());
    // The cast is safe, because CHOLMOD does not write to its input.
    matrix.p = const_cast<int*>(lower.outerIndexPtr());
    matrix.i = const_cast<int*>(lower.innerIndexPtr());
    matrix.x = const_cast<double*>(lower.valuePtr());
    matrix.stype = -1; // the lower triangle is stored
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = 1;
    matrix.packed = 1;
    return matrix;
  }

  cholmod_common Common{};
  cholmod_factor* Factor = nullptr;
  double Bytes = 0.0;
};
} // namespace

std::unique_ptr<StiffnessFactor> makeSupernodalFactor()
{
  return std::make_unique<SupernodalFactor>();
}
} // namespace palpate

#endif
