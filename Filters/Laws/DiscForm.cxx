// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/DiscForm.h"

#include "Laws/PointForm.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

constexpr int TermCount = 11;
constexpr int Padded = 12; // number of terms rounded up to a multiple of four, for vector registers
using DiscTerms = Eigen::Matrix<double, TermCount, 1>;
constexpr int TiltTerms = 0;   // index of the first of two terms
constexpr int SquareTerms = 2; // index of the first of three terms
constexpr int CubeTerms = 5;   // index of the first of four terms
constexpr int FourthTerm = 9;
constexpr int OffsetTerm = 10;

constexpr double Reach = 1.25; // largest distance of the points, in contact radii
// Radius that contains two rings of neighbours, in mean distances of points.
constexpr double TwoRings = 2.6;
constexpr std::size_t Fewest = 12; // least number of points for a fit
// Largest number of points in a disc. A disc has more points if the mesh is far finer there than
// elsewhere. In this case averaging over neighbours takes less time than a fit.
constexpr std::size_t Most = 2000;
// Number of points used in a fit; if there are more, a random part of them is used.
constexpr std::size_t Enough = 96;
// Smallest cosine between normals. This excludes points beyond a sharp edge.
constexpr double LeastFacing = 0.3;
// Ridge terms of the fit, divided by the sum of weights, if lengths are in contact radii.
constexpr double TiltRidge = 0.005;
constexpr double CubeRidge = 0.01;
constexpr double FourthRidge = 0.003;
constexpr double OffsetRidge = 0.01;

/// A number that looks random, from the bits of a place. It does not depend on the point's index,
/// so that a body in pieces has the same curvature as the whole.
std::uint64_t drawnFrom(const std::array<double, 3>& place)
{
  std::uint64_t number = 0;
  for (const double coordinate : place)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);
    number = (number ^ bits) * 0x9e3779b97f4a7c15U;
    number ^= number >> 29;
  }
  return number >> 8;
}

/// Four doubles that are processed together; two at a time on a processor without AVX.
using FourTerms [[gnu::vector_size(32)]] = double;
/// The same in memory that need not begin at a multiple of 32 bytes. (Not for `auto` or a parameter
/// of a template, which would lose the attributes.)
using StoredTerms [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

/// The sums over all points that a fit needs.
struct DiscSums
{
  /// The lower triangle of weight * terms * termsᵀ, column by column.
  double products[Padded * Padded];
  double heights[Padded]; ///< of weight * height * terms
};

/// Sets the columns from `First` to `First` + 3 of the products.
template <int First>
[[gnu::always_inline]] inline void sumColumns(
  const double* terms, const double* weighted, std::size_t count, double* products) noexcept
{
  constexpr int fours = (Padded - First) / 4;
  // A compiler keeps these in vector registers. Eigen's rankUpdate of a matrix in memory takes four
  // times as long.
  FourTerms sums[4][fours] = {};
  for (std::size_t i = First; i < count * Padded; i += Padded)
  {
    const StoredTerms* rows = reinterpret_cast<const StoredTerms*>(terms + i);
    for (int column = 0; column < 4; ++column)
    {
      for (int four = 0; four < fours; ++four)
      {
        sums[column][four] += weighted[i + static_cast<std::size_t>(column)] * rows[four];
      }
    }
  }
  for (int column = 0; column < 4; ++column)
  {
    StoredTerms* to = reinterpret_cast<StoredTerms*>(products + Padded * (First + column) + First);
    for (int four = 0; four < fours; ++four)
    {
      to[four] = sums[column][four];
    }
  }
}

// The same instructions in the same order with vectors of two or four, thus the same bits. A thread
// sanitizer cannot run the function that chooses between them.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
[[gnu::target_clones("avx", "default")]]
#endif
void sumTerms(const double* fitted, std::size_t count, double* terms, double* weighted,
  DiscSums& sums) noexcept
{
  constexpr int fours = Padded / 4;
  FourTerms heights[fours] = {};
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = fitted[4 * i];
    const double y = fitted[4 * i + 1];
    const double height = fitted[4 * i + 2];
    const double weight = fitted[4 * i + 3];
    const double square = x * x + y * y;
    const double heightWeight = weight * height;
    StoredTerms* all = reinterpret_cast<StoredTerms*>(terms + Padded * i);
    StoredTerms* weightedAll = reinterpret_cast<StoredTerms*>(weighted + Padded * i);
    all[0] = FourTerms{ x, y, 0.5 * x * x, x * y };
    all[1] = FourTerms{ 0.5 * y * y, x * x * x, x * x * y, x * y * y };
    all[2] = FourTerms{ y * y * y, square * square, 1.0, 0.0 }; // the last one is unused
    for (int four = 0; four < fours; ++four)
    {
      weightedAll[four] = weight * all[four];
      heights[four] += heightWeight * all[four];
    }
  }
  StoredTerms* heightSums = reinterpret_cast<StoredTerms*>(sums.heights);
  for (int four = 0; four < fours; ++four)
  {
    heightSums[four] = heights[four];
  }
  sumColumns<0>(terms, weighted, count, sums.products);
  sumColumns<4>(terms, weighted, count, sums.products);
  sumColumns<8>(terms, weighted, count, sums.products);
}

DiscTerms ridges()
{
  DiscTerms ridge = DiscTerms::Zero();
  ridge.segment<2>(TiltTerms).setConstant(TiltRidge);
  ridge.segment<4>(CubeTerms).setConstant(CubeRidge);
  ridge[FourthTerm] = FourthRidge;
  ridge[OffsetTerm] = OffsetRidge;
  return ridge;
}
} // namespace

std::vector<NormalPoint> normalPoints(const TriangleSpans& surface, const float* normals)
{
  std::vector<NormalPoint> points(surface.pointCount);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    std::copy_n(surface.points + 3 * i, 3, points[i].place.begin());
    std::copy_n(normals + 3 * i, 3, points[i].normal.begin());
    points[i].drawn = drawnFrom(points[i].place);
  }
  return points;
}

DiscForms::DiscForms(const std::vector<NormalPoint>& points, const PointRings& rings,
  double spacing, double contactRadius)
  : Points(points)
  , Rings(rings)
  , Radius(contactRadius)
  , Spacing(spacing)
  , Passed(points.size(), 0)
{
}

/// Collects the points that are connected within this distance and face the same way, until there
/// are too many.
void DiscForms::gather(std::size_t point, double reach)
{
  // Copies of members, which a compiler otherwise reads again after each write.
  const NormalPoint* points = this->Points.data();
  std::uint32_t* passed = this->Passed.data();
  const std::uint32_t search = ++this->Search;
  const Vector3d here = points[point].placeVector();
  const Vector3d normal = points[point].normalVector();
  const double square = reach * reach;
  passed[point] = search;
  this->Near = { point };
  for (std::size_t i = 0; i < this->Near.size() && this->Near.size() <= Most; ++i)
  {
    this->Rings.forEachNeighbour(this->Near[i],
      [&](std::size_t other)
      {
        if (passed[other] == search)
        {
          return;
        }
        passed[other] = search;
        const NormalPoint& at = points[other];
        if ((at.placeVector() - here).squaredNorm() < square &&
          at.normalVector().dot(normal) > LeastFacing)
        {
          this->Near.push_back(other);
        }
      });
  }
}

std::optional<DiscForm> DiscForms::fit(std::size_t point)
{
  const Vector3d normal = this->Points[point].normalVector();
  if (!(normal.squaredNorm() > 0.0))
  {
    return {};
  }
  this->gather(point, Reach * this->Radius);
  if (this->Near.size() < Fewest)
  {
    this->gather(point, TwoRings * this->Spacing);
  }
  if (this->Near.size() < Fewest || this->Near.size() > Most)
  {
    return {};
  }
  const TangentFrame frame(normal);
  const Vector3d here = this->Points[point].placeVector();
  const double coarse = this->Spacing / this->Radius;
  const double width = 2.0 * std::max(1.0, 1.2 * coarse * coarse);
  double squares = 0.0;
  double weights = 0.0;
  this->Fitted.resize(4 * this->Near.size());
  double* fitted = this->Fitted.data();
  const std::uint64_t stride = 1 + this->Near.size() / Enough;
  for (const std::size_t other : this->Near)
  {
    const NormalPoint& at = this->Points[other];
    if (stride > 1 && other != point && at.drawn % stride != 0)
    {
      continue;
    }
    const Vector3d away = (at.placeVector() - here) / this->Radius;
    const double x = away.dot(frame.first);
    const double y = away.dot(frame.second);
    const double height = -away.dot(normal);
    const double weight = std::exp(-(x * x + y * y) / width);
    fitted[0] = x;
    fitted[1] = y;
    fitted[2] = height;
    fitted[3] = weight;
    fitted += 4;
    squares += weight * height * height;
    weights += weight;
  }
  const auto count = static_cast<std::size_t>(fitted - this->Fitted.data()) / 4;
  if (this->Terms.size() < Padded * count)
  {
    this->Terms.resize(Padded * count);
    this->Weighted.resize(Padded * count);
  }
  DiscSums sums{};
  sumTerms(this->Fitted.data(), count, this->Terms.data(), this->Weighted.data(), sums);
  const DiscTerms heights = Eigen::Map<const DiscTerms>(sums.heights);
  Eigen::Matrix<double, TermCount, TermCount> products =
    Eigen::Map<const Eigen::Matrix<double, Padded, Padded>>(sums.products)
      .topLeftCorner<TermCount, TermCount>();
  products.diagonal() += weights * ridges();
  const DiscTerms found = products.selfadjointView<Eigen::Lower>().ldlt().solve(heights);
  // The ridge terms also count as residuals.
  const double left = std::max(0.0, squares - found.dot(heights)) / weights;
  const double added = 8.0 / 5.0 * found[FourthTerm] + 3.0 * found[OffsetTerm];
  const Vector3d form = found.segment<3>(SquareTerms) + added * Vector3d(1.0, 0.0, 1.0);
  return DiscForm{ form / this->Radius, std::sqrt(left) / this->Radius };
}
} // namespace palpate
