// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/ContactKernelFit.h"

#include "Solids/FiniteElements/PatchLoad.h"
#include "Mechanics/ReducedModulus.h"
#include "Solids/TrueShape/DirectedCompliance.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Number of points that are needed for a polynomial of degree 0, 2, 4, 6.
constexpr std::array<std::size_t, 4> PointsOfOrder = { 1, 9, 21, 37 };
/// If the smallest pivot of a least-squares fit is below this fraction of the largest pivot, the
/// points do not determine the terms.
constexpr double LeastPivot = 1e-3;

/// Largest weight of the points under a contact that is small compared with its disc. With a larger
/// weight, the other points would have no effect.
constexpr double LargestEmphasis = 100.0;

int termsOfDegree(int degree)
{
  return (degree + 1) * (degree + 2) / 2;
}

/// Returns the mean of cos^i sin^j over the circle for even i and j, (i-1)!! (j-1)!! / (i+j)!!.
double angleMean(int i, int j)
{
  double mean = 1.0;
  for (int k = 1; k < i; k += 2)
  {
    mean *= k;
  }
  for (int k = 1; k < j; k += 2)
  {
    mean *= k;
  }
  for (int k = 2; k <= i + j; k += 2)
  {
    mean /= k;
  }
  return mean;
}

/// Returns the weight of a point at a distance of t contact radii. It is 1 up to t = 1, and
/// decreases to 0 at DiscRatio.
double fade(double t)
{
  const double s =
    std::clamp((RegularGreen::DiscRatio - t) / (RegularGreen::DiscRatio - 1.0), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// Returns the matrix that maps values at points to fitted terms. The terms are the even terms of
/// the mean over angles (`order` rows), followed by the two slopes, for the disc scaled to radius
/// 1. If the disc is larger than the contact, the points under the contact have as much weight as
/// all points of the disc together. This is because H varies near an edge over a disc of few
/// elements.
Eigen::MatrixXd fitOperator(const std::vector<DiscPoint>& points, Eigen::Index count, double radius,
  double contact, int order, bool& good)
{
  const int degree = 2 * (order - 1);
  const int terms = termsOfDegree(degree);
  Eigen::MatrixXd system(count, terms);
  Eigen::VectorXd weights(count);
  const double emphasis = std::min(LargestEmphasis, radius * radius / (contact * contact));
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const DiscPoint& point = points[static_cast<std::size_t>(i)];
    const Eigen::Vector2d at = point.at / radius;
    weights[i] = std::sqrt(
      fade(at.norm()) * point.area * (1.0 + (emphasis - 1.0) * fade(point.distance / contact)));
    int term = 0;
    for (int d = 0; d <= degree; ++d)
    {
      for (int k = 0; k <= d; ++k)
      {
        system(i, term++) = weights[i] * std::pow(at[0], d - k) * std::pow(at[1], k);
      }
    }
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(system);
  const double least = std::abs(qr.matrixQR()(terms - 1, terms - 1));
  good = least > LeastPivot * std::abs(qr.matrixQR()(0, 0));
  Eigen::MatrixXd taken = Eigen::MatrixXd::Zero(order + 2, terms);
  for (int m = 0; m < order; ++m)
  {
    for (int k = 0; k <= 2 * m; k += 2)
    {
      taken(m, (2 * m == 0 ? 0 : termsOfDegree(2 * m - 1)) + k) = angleMean(2 * m - k, k);
    }
  }
  if (order > 1)
  {
    taken(order, 1) = taken(order + 1, 2) = 1.0;
  }
  // The product taken · A⁺ is computed with A Π = Q R from the right. This solves a few rows
  // instead of one system per point.
  Eigen::MatrixXd rows = (taken * qr.colsPermutation()).transpose();
  qr.matrixQR()
    .topLeftCorner(terms, terms)
    .triangularView<Eigen::Upper>()
    .transpose()
    .solveInPlace(rows);
  const Eigen::MatrixXd thin = qr.householderQ() * Eigen::MatrixXd::Identity(count, terms);
  return rows.transpose() * thin.transpose() * weights.asDiagonal();
}

/// The fit on one disc.
struct DiscFit
{
  Eigen::MatrixXd rows; ///< matrix of the fit, from fitOperator()
  Eigen::Index count = 0;
  double disc = 0.0; ///< radius of the disc, mm
  int order = 0;

  /// Returns the factors from powers of r/disc to powers of r/a.
  Eigen::VectorXd scale(double radius) const
  {
    Eigen::VectorXd powers(this->order);
    for (int m = 0; m < this->order; ++m)
    {
      powers[m] = std::pow(radius / this->disc, 2 * m);
    }
    return powers;
  }

  Eigen::VectorXd drop(const std::vector<DiscPoint>& points, double radius) const
  {
    Eigen::VectorXd heights(this->count);
    for (Eigen::Index i = 0; i < this->count; ++i)
    {
      heights[i] = points[static_cast<std::size_t>(i)].drop;
    }
    return this->scale(radius).cwiseProduct(this->rows.topRows(this->order) * heights);
  }
};

/// Returns the fit around a contact of the given radius, with the largest order for which there are
/// enough points.
DiscFit fitDisc(const std::vector<DiscPoint>& points, double radius, int largestOrder)
{
  const std::size_t ring = std::min(PointsOfOrder[1], points.size()) - 1;
  DiscFit fit;
  fit.disc = std::max(radius, points[ring].distance * (1.0 + 1e-9));
  const auto within = [&](double ratio)
  {
    return static_cast<std::size_t>(
      std::partition_point(points.begin(), points.end(),
        [&](const DiscPoint& p) { return p.distance < ratio * fit.disc; }) -
      points.begin());
  };
  const std::size_t told = within(0.5 * (1.0 + RegularGreen::DiscRatio));
  fit.count = static_cast<Eigen::Index>(within(RegularGreen::DiscRatio));
  fit.order = std::min(largestOrder, ContactKernel::LargestOrder);
  while (fit.order > 1 && told < PointsOfOrder[static_cast<std::size_t>(fit.order - 1)])
  {
    --fit.order;
  }
  bool good = false;
  fit.rows = fitOperator(points, fit.count, fit.disc, radius, fit.order, good);
  while (!good && fit.order > 1)
  {
    fit.rows = fitOperator(points, fit.count, fit.disc, radius, --fit.order, good);
  }
  return fit;
}
} // namespace

ContactKernelFit::ContactKernelFit(const RegularGreen& green, std::int32_t point)
{
  const SurfaceDisc* disc = green.disc(point);
  if (disc == nullptr)
  {
    return;
  }
  const ElasticBody& body = green.body();
  const ElasticMaterial material = body.materialAt(body.surface().node(point));
  this->Site.status = disc->status;
  this->Site.material = material;
  this->Site.reducedModulus = reducedModulus(material.youngsModulus, material.poissonRatio);
  this->Site.limit = disc->limit;
  this->Site.limitedBy = disc->limit < green.radius() ? disc->limitedBy : PatchStatus::Valid;
  this->Site.largestRadius = std::min(green.radius(), disc->limit);
  this->Site.toHeld =
    green.held().distance(body.surface().position(point), body.surface().normal(point));
  this->Site.spacing = body.surface().spacing(point);
  this->Site.elements = green.elementError(point);
  for (const DiscPoint& at : disc->points)
  {
    if (green.isSource(at.point))
    {
      this->Points.push_back(at);
      // The points of a thinned set are evenly spread. Therefore all have the same weight.
      this->Points.back().area = green.spacing() > 0.0 ? 1.0 : at.area;
    }
  }
  if (this->Points.size() < disc->points.size())
  {
    this->Surface = disc->points;
  }
  if (!this->Points.empty())
  {
    this->Site.nearestSource = this->Points.front().distance;
  }
  else if (this->Site.status == PatchStatus::Valid)
  {
    this->Site.status = PatchStatus::Degenerate;
  }
  const auto count = static_cast<Eigen::Index>(this->Points.size());
  this->Values.resize(count, count);
  this->Normals.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    this->Normals.col(i) = body.surface().normal(this->Points[static_cast<std::size_t>(i)].point);
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      const double value = green.at(this->Points[static_cast<std::size_t>(i)].point,
        this->Points[static_cast<std::size_t>(j)].point);
      this->Values(i, j) = this->Values(j, i) = value;
      this->Asymmetry = std::max(this->Asymmetry,
        green.asymmetry(this->Points[static_cast<std::size_t>(i)].point,
          this->Points[static_cast<std::size_t>(j)].point));
    }
  }
  if (count > 0)
  {
    this->Asymmetry /= this->Values.cwiseAbs().maxCoeff();
    Eigen::Matrix3Xd motions(3, count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      motions.col(i) = green.motion(this->Points[static_cast<std::size_t>(i)].point);
    }
    const Eigen::VectorXd alike =
      Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count));
    this->Site.directed = DirectedCompliance(this->Normals, motions, alike)
                            .inFrame(tangentFrame(body.surface().normal(point)));
  }
}

ContactKernel ContactKernelFit::at(double radius, int largestOrder) const
{
  ContactKernel kernel;
  if (this->Site.status != PatchStatus::Valid || !(radius > 0.0) || !std::isfinite(radius))
  {
    return kernel;
  }
  const DiscFit fit = fitDisc(this->Points, radius, largestOrder);
  const Eigen::MatrixXd all =
    fit.rows * this->Values.topLeftCorner(fit.count, fit.count) * fit.rows.transpose();
  const Eigen::VectorXd scale = fit.scale(radius);
  kernel.order = fit.order;
  kernel.normal = this->Normals.leftCols(fit.count) * fit.rows.row(0).transpose();
  kernel.coefficients.topLeftCorner(fit.order, fit.order) =
    scale.asDiagonal() * all.topLeftCorner(fit.order, fit.order) * scale.asDiagonal();
  if (this->Surface.empty())
  {
    kernel.gap.drop.head(fit.order) = fit.drop(this->Points, radius);
  }
  else
  {
    const DiscFit shape = fitDisc(this->Surface, radius, largestOrder);
    kernel.gap.drop.head(shape.order) = shape.drop(this->Surface, radius);
  }
  kernel.gap.drop[0] = 0.0;
  kernel.tilt = all.col(0).tail<2>() / fit.disc;
  return kernel;
}
} // namespace palpate
