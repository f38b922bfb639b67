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

/// Returns a pseudo-random number computed from the bits of a position. It does not depend on the
/// index of the point, so that a body in pieces has the same curvature as the whole body.
std::uint64_t drawn(const Vector3d& place)
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

/// Returns the terms of the height polynomial at a position in the tangent plane.
DiscTerms termsAt(double x, double y)
{
  const double square = x * x + y * y;
  DiscTerms terms;
  terms << x, y, 0.5 * x * x, x * y, 0.5 * y * y, x * x * x, x * x * y, x * y * y, y * y * y,
    square * square, 1.0;
  return terms;
}

/// Sets the columns from `First` to `First` + 3 in the lower triangle of the sum of weighted *
/// termsᵀ over all points.
template <int First>
void sumColumns(const std::vector<double>& terms, const std::vector<double>& weighted,
  Eigen::Matrix<double, Padded, Padded>& products)
{
  constexpr int rows = Padded - First;
  // The compiler keeps these sums in vector registers. Eigen's rankUpdate of a matrix in memory
  // takes four times as long.
  double sums[4][rows] = {};
  for (std::size_t i = First; i < terms.size(); i += Padded)
  {
    for (std::size_t column = 0; column < 4; ++column)
    {
      for (std::size_t row = 0; row < rows; ++row)
      {
        sums[column][row] += weighted[i + column] * terms[i + row];
      }
    }
  }
  for (int column = 0; column < 4; ++column)
  {
    products.col(First + column).template tail<rows>() =
      Eigen::Map<const Eigen::Matrix<double, rows, 1>>(sums[column]);
  }
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

DiscForms::DiscForms(const TriangleSpans& surface, const float* normals, const PointRings& rings,
  double spacing, double contactRadius)
  : Surface(surface)
  , Normals(normals)
  , Rings(rings)
  , Radius(contactRadius)
  , Spacing(spacing)
  , Passed(surface.pointCount, 0)
{
}

Vector3d DiscForms::placeOf(std::size_t point) const
{
  return Eigen::Map<const Vector3d>(this->Surface.points + 3 * point);
}

Vector3d DiscForms::normalOf(std::size_t point) const
{
  return Eigen::Map<const Eigen::Vector3f>(this->Normals + 3 * point).cast<double>();
}

/// Collects the connected points within the distance `reach` (mm) whose normals are similar to that
/// of the point. Stops when there are more than `Most` points.
void DiscForms::gather(std::size_t point, double reach)
{
  const Vector3d here = this->placeOf(point);
  const Vector3d normal = this->normalOf(point);
  ++this->Search;
  this->Passed[point] = this->Search;
  this->Near = { point };
  for (std::size_t i = 0; i < this->Near.size() && this->Near.size() <= Most; ++i)
  {
    this->Rings.forEachNeighbour(this->Near[i],
      [&](std::size_t other)
      {
        const bool isSeen = this->Passed[other] == this->Search;
        this->Passed[other] = this->Search;
        if (!isSeen && (this->placeOf(other) - here).squaredNorm() < reach * reach &&
          this->normalOf(other).dot(normal) > LeastFacing)
        {
          this->Near.push_back(other);
        }
      });
  }
}

std::optional<DiscForm> DiscForms::fit(std::size_t point)
{
  const Vector3d normal = this->normalOf(point);
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
  const Vector3d here = this->placeOf(point);
  const double coarse = this->Spacing / this->Radius;
  const double width = 2.0 * std::max(1.0, 1.2 * coarse * coarse);
  DiscTerms heights = DiscTerms::Zero();
  double squares = 0.0;
  double weights = 0.0;
  this->Terms.clear();
  this->Weighted.clear();
  const std::uint64_t stride = 1 + this->Near.size() / Enough;
  for (const std::size_t other : this->Near)
  {
    if (stride > 1 && other != point && drawn(this->placeOf(other)) % stride != 0)
    {
      continue;
    }
    const Vector3d away = (this->placeOf(other) - here) / this->Radius;
    const double x = away.dot(frame.first);
    const double y = away.dot(frame.second);
    const double height = -away.dot(normal);
    const double weight = std::exp(-(x * x + y * y) / width);
    const DiscTerms terms = termsAt(x, y);
    const std::size_t end = this->Terms.size();
    this->Terms.resize(end + Padded); // the unused terms are 0
    this->Weighted.resize(end + Padded);
    Eigen::Map<DiscTerms>(this->Terms.data() + end) = terms;
    Eigen::Map<DiscTerms>(this->Weighted.data() + end) = weight * terms;
    heights += weight * height * terms;
    squares += weight * height * height;
    weights += weight;
  }
  Eigen::Matrix<double, Padded, Padded> sums = Eigen::Matrix<double, Padded, Padded>::Zero();
  sumColumns<0>(this->Terms, this->Weighted, sums);
  sumColumns<4>(this->Terms, this->Weighted, sums);
  sumColumns<8>(this->Terms, this->Weighted, sums);
  Eigen::Matrix<double, TermCount, TermCount> products = sums.topLeftCorner<TermCount, TermCount>();
  products.diagonal() += weights * ridges();
  const DiscTerms found = products.selfadjointView<Eigen::Lower>().ldlt().solve(heights);
  // The ridge terms also count as residuals.
  const double left = std::max(0.0, squares - found.dot(heights)) / weights;
  const double added = 8.0 / 5.0 * found[FourthTerm] + 3.0 * found[OffsetTerm];
  const Vector3d form = found.segment<3>(SquareTerms) + added * Vector3d(1.0, 0.0, 1.0);
  return DiscForm{ form / this->Radius, std::sqrt(left) / this->Radius };
}
} // namespace palpate
