// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/SurfaceGap.h"

#include "Solids/FiniteElements/PatchLoad.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>

namespace palpate
{
namespace
{
constexpr double RingRatio = 0.82;
/// Number of rings outside the largest contact. The radius of the innermost ring is a twentieth of
/// the radius of the largest contact.
constexpr int RingsBeyond = 3;

/// Smallest number of rings for the gap of a contact. For a contact that covers fewer rings, the
/// gap of this number of rings is used.
constexpr int LeastRings = 5;

/// Returns n I_n, where I_n = ∫_0^1 t^n / √(1 - t²) dt. For a power r^k in a harmonic of order m, n
/// = m + 1 + k and g = n I_n a^k.
double powerUnderContact(int n)
{
  double integral = n % 2 == 0 ? 0.5 * Pi : 1.0;
  for (int k = n; k > 1; k -= 2)
  {
    integral *= (k - 1.0) / k;
  }
  return n * integral;
}
} // namespace

Eigen::Matrix3d SurfaceGap::frame(const Eigen::Vector3d& outwardNormal)
{
  return tangentFrame(outwardNormal);
}

double SurfaceGap::reachFor(double radius)
{
  return radius / ring(Rings - 1 - RingsBeyond);
}

double SurfaceGap::ring(int k)
{
  static const std::array<double, Rings> radii = []
  {
    std::array<double, Rings> all{};
    for (int i = 0; i < Rings; ++i)
    {
      all[static_cast<std::size_t>(i)] = std::pow(RingRatio, Rings - 1 - i);
    }
    return all;
  }();
  return radii[static_cast<std::size_t>(k)];
}

SurfaceGap::SurfaceGap(double radius, const Heights& heights)
  : Radius(radius)
  , Known(std::clamp(heights.known, 0, Rings))
  , Surface(heights.surface)
{
  for (int k = 0; k < this->Known; ++k)
  {
    const auto at = static_cast<std::size_t>(k);
    const auto row = heights.surface.row(k);
    this->Mean[at] = row.mean();
    this->Between[at] = (row - heights.facets.row(k)).squaredNorm() / Angles;
    this->Uneven[at] = heights.uneven.row(k).squaredNorm() / Angles;
    Eigen::Matrix<double, 1, Angles> rest = row.array() - row.mean();
    for (int m = 1; m <= Harmonics; ++m)
    {
      Eigen::Matrix<double, 2, Angles> waves;
      for (int j = 0; j < Angles; ++j)
      {
        const double angle = 2.0 * Pi * m * j / Angles;
        waves.col(j) << std::cos(angle), std::sin(angle);
      }
      const Eigen::Vector2d amplitude = 2.0 / Angles * (waves * row.transpose());
      rest -= amplitude.transpose() * waves;
      this->Waves[static_cast<std::size_t>(m - 1)][at] = amplitude;
    }
    this->Left[at] = rest.squaredNorm() / Angles;
  }
}

Eigen::Vector2d SurfaceGap::place(int k, int j) const
{
  const double angle = 2.0 * Pi * j / Angles;
  return this->Radius * ring(k) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

SurfaceGap::Spectrum::Spectrum(const SurfaceGap& gap)
  : Radius(gap.Radius)
  , Known(gap.Known)
{
  Eigen::Matrix<double, Angles, Angles> waves;
  for (int j = 0; j < Angles; ++j)
  {
    for (int m = 0; m <= Angles / 2; ++m)
    {
      const double angle = 2.0 * Pi * m * j / Angles;
      const double part = (m == 0 || m == Angles / 2 ? 1.0 : 2.0) / Angles;
      waves(std::max(0, 2 * m - 1), j) = part * std::cos(angle);
      if (m > 0 && m < Angles / 2)
      {
        waves(2 * m, j) = part * std::sin(angle);
      }
    }
  }
  this->Amplitudes.setZero();
  this->Amplitudes.leftCols(this->Known) = waves * gap.Surface.topRows(this->Known).transpose();
}

SurfaceGap::Spectrum::Between SurfaceGap::Spectrum::between(double r) const
{
  const double t = r / this->Radius;
  if (!(t > ring(0)))
  {
    return { 0, 0, t * t / (ring(0) * ring(0)) };
  }
  const int outer = Rings - 1 - static_cast<int>(std::log(t) / std::log(RingRatio));
  const int high = std::min(this->Known - 1, outer);
  const int low = std::max(0, high - 1);
  const double before = ring(low) * ring(low);
  return { low, high, (t * t - before) / (ring(high) * ring(high) - before) };
}

double SurfaceGap::Spectrum::amplitude(int i, const Between& rings) const
{
  const double from = rings.low < rings.high ? this->Amplitudes(i, rings.low) : 0.0;
  return from + rings.part * (this->Amplitudes(i, rings.high) - from);
}

double SurfaceGap::Spectrum::mean(double r) const
{
  return this->Known > 0 ? this->amplitude(0, this->between(r)) : 0.0;
}

double SurfaceGap::Spectrum::around(const Eigen::Vector2d& place) const
{
  const double r = place.norm();
  if (!(r > 0.0) || this->Known == 0)
  {
    return 0.0;
  }
  const Between rings = this->between(r);
  const std::complex<double> turn(place[0] / r, place[1] / r);
  std::complex<double> wave = turn;
  double sum = 0.0;
  for (int m = 1; m < Angles / 2; ++m, wave *= turn)
  {
    sum +=
      this->amplitude(2 * m - 1, rings) * wave.real() + this->amplitude(2 * m, rings) * wave.imag();
  }
  return sum + this->amplitude(Angles - 1, rings) * wave.real();
}

double SurfaceGap::reach() const
{
  return this->Known > 0 ? this->Radius * ring(this->Known - 1) : 0.0;
}

GapTerms SurfaceGap::at(double a) const
{
  GapTerms terms;
  if (this->Known < LeastRings || !(a > 0.0))
  {
    return terms;
  }
  // Each ring represents an annulus. Its weight is the fraction of the force on the annulus.
  const double least = this->Radius * ring(LeastRings - 1);
  const double disc = std::clamp(a, least, this->reach());
  Eigen::VectorXd weights(this->Known);
  int count = 0;
  double sum = 0.0;
  double inner = 0.0;
  for (int k = 0; k < this->Known && inner < disc; ++k)
  {
    const double here = this->Radius * ring(k);
    const double outer =
      k + 1 < this->Known ? std::min(disc, 0.5 * here * (1.0 + 1.0 / RingRatio)) : disc;
    weights[k] = std::sqrt(disc * disc - inner * inner) - std::sqrt(disc * disc - outer * outer);
    sum += weights[k];
    inner = outer;
    count = k + 1;
  }
  weights /= sum;
  const auto fitted = [&](int first, int parts, double meanSquare, const auto& valueAt)
  {
    // This is a weighted least-squares fit of Σ c_j (r/disc)^(first + 2j).
    Eigen::MatrixXd system(count, parts);
    Eigen::MatrixXd values(count, valueAt(0).size());
    for (int k = 0; k < count; ++k)
    {
      const double root = std::sqrt(weights[k]);
      const double t = this->Radius * ring(k) / disc;
      for (int j = 0; j < parts; ++j)
      {
        system(k, j) = root * std::pow(t, first + 2 * j);
      }
      values.row(k) = root * valueAt(k).transpose();
    }
    const Eigen::MatrixXd found = system.householderQr().solve(values);
    terms.left += meanSquare * (values - system * found).squaredNorm();
    return Eigen::MatrixXd(found);
  };
  using One = Eigen::Matrix<double, 1, 1>;
  const Eigen::MatrixXd mean =
    fitted(0, 3, 1.0, [&](int k) { return One(this->Mean[static_cast<std::size_t>(k)]); });
  const double scale = a / disc;
  for (int m = 0; m < 3; ++m)
  {
    terms.drop[m] = mean(m, 0) * std::pow(scale, 2 * m);
  }
  for (int m = 1; m <= Harmonics; ++m)
  {
    const auto& waves = this->Waves[static_cast<std::size_t>(m - 1)];
    const Eigen::MatrixXd found =
      fitted(m, 2, 0.5, [&](int k) { return waves[static_cast<std::size_t>(k)]; });
    Eigen::Vector2d g = Eigen::Vector2d::Zero();
    for (int j = 0; j < 2; ++j)
    {
      const int power = m + 2 * j;
      g += powerUnderContact(m + 1 + power) * std::pow(scale, power) * found.row(j).transpose();
    }
    if (m == 1)
    {
      terms.lean = g / (2.0 * a);
    }
    else
    {
      terms.waves += g.squaredNorm();
    }
  }
  for (int k = 0; k < count; ++k)
  {
    terms.left += weights[k] * this->Left[static_cast<std::size_t>(k)];
    terms.facets += weights[k] * this->Between[static_cast<std::size_t>(k)];
    terms.uneven += weights[k] * this->Uneven[static_cast<std::size_t>(k)];
  }
  terms.facets = std::sqrt(terms.facets);
  terms.uneven = std::sqrt(terms.uneven);
  return terms;
}
} // namespace palpate
