// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/RelaxationStart.h"

#include "Mechanics/Numerics/NonNegativeLeastSquares.h"
#include "Mechanics/Relaxation/QuasiLinearElement.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double TimesPerDecade = 3.0;
// Fraction of the largest force. Readings with smaller forces are ignored, because the contact may
// be about to end.
constexpr double LeastForce = 0.1;
// Smallest strength of the slow response, as a fraction of the whole response.
constexpr double LeastShare = 0.02;

// Strength of the branch that is used if none is found, as a fraction of the slow response.
constexpr double DefaultShare = 0.2;

std::vector<double> timeGrid(const TimeWindow& window)
{
  if (!(window.longest > window.shortest))
  {
    return { window.longest };
  }
  const double decades = std::log10(window.longest / window.shortest);
  const int count = std::clamp(static_cast<int>(std::ceil(TimesPerDecade * decades)), 1, 30);
  std::vector<double> times;
  for (int i = 0; i <= count; ++i)
  {
    times.push_back(window.shortest * std::pow(10.0, decades * i / count));
  }
  return times;
}
} // namespace

RelaxationSpectrum RelaxationSpectrum::merged(std::size_t count) const
{
  RelaxationSpectrum left = *this;
  while (left.time.size() > count)
  {
    // Ward's rule: merges the pair of branches for which the change is smallest.
    std::size_t best = 0;
    double least = 0.0;
    for (std::size_t i = 0; i + 1 < left.time.size(); ++i)
    {
      const double a = left.strength[i];
      const double b = left.strength[i + 1];
      const double apart = std::log(left.time[i + 1] / left.time[i]);
      const double moved = a * b / (a + b) * apart * apart;
      if (i == 0 || moved < least)
      {
        best = i;
        least = moved;
      }
    }
    const double a = left.strength[best];
    const double b = left.strength[best + 1];
    left.time[best] =
      std::exp((a * std::log(left.time[best]) + b * std::log(left.time[best + 1])) / (a + b));
    left.strength[best] = a + b;
    const auto next = static_cast<std::ptrdiff_t>(best) + 1;
    left.time.erase(left.time.begin() + next);
    left.strength.erase(left.strength.begin() + next);
  }
  return left;
}

RelaxationSpectrum startingSpectrum(const std::vector<PressHistory>& histories,
  const RelaxingBody& about, const std::shared_ptr<const LayerKernel>& kernel,
  const TimeWindow& window)
{
  if (!(window.shortest > 0.0)) // there is no contact
  {
    return {};
  }
  const std::vector<double> times = timeGrid(window);
  const auto branches = static_cast<Index>(times.size());
  std::vector<VectorXd> rows;
  std::vector<double> forces;
  for (std::size_t c = 0; c < histories.size(); ++c)
  {
    const PressHistory& history = histories[c];
    const auto netForce = [&](std::size_t i)
    { return history.force[i] - about.baseline[c].at(history.deflection[i]); };
    double largest = 0.0;
    for (std::size_t i = 0; i < history.size(); ++i)
    {
      largest = std::max(largest, netForce(i));
    }
    std::vector<QuasiLinearElement> memory(times.size());
    double before = 0.0;
    for (std::size_t i = 0; i < history.size(); ++i)
    {
      const double slow = bodyResponse(
        about.body, *history.tool, kernel, history.deflection[i] - about.contactOffset[c])
                            .force;
      const double seconds = i > 0 ? history.time[i] - history.time[i - 1] : 0.0;
      VectorXd row(branches + 1);
      row[0] = slow;
      for (std::size_t k = 0; k < times.size(); ++k)
      {
        PronySeries one;
        one.add(1.0, times[k]);
        row[static_cast<Index>(k) + 1] =
          memory[k].follow(slow - before, RelaxationStep(one, seconds));
      }
      before = slow;
      if (history.readings[i] > 0.0 && netForce(i) > LeastForce * largest && row.allFinite())
      {
        const double weight = std::sqrt(history.readings[i]);
        rows.emplace_back(weight * row);
        forces.push_back(weight * netForce(i));
      }
    }
  }
  RelaxationSpectrum spectrum;
  if (static_cast<Index>(rows.size()) <= branches)
  {
    return spectrum;
  }
  MatrixXd columns(static_cast<Index>(rows.size()), branches + 1);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    columns.row(static_cast<Index>(i)) = rows[i].transpose();
  }
  const VectorXd length = columns.colwise().norm().cwiseMax(1e-300);
  const VectorXd shares = nonNegativeLeastSquares(columns * length.cwiseInverse().asDiagonal(),
    Eigen::Map<const VectorXd>(forces.data(), static_cast<Index>(forces.size())))
                            .cwiseQuotient(length);
  spectrum.slow = shares[0];
  for (std::size_t k = 0; k < times.size(); ++k)
  {
    if (shares[static_cast<Index>(k) + 1] > 0.0)
    {
      spectrum.time.push_back(times[k]);
      spectrum.strength.push_back(shares[static_cast<Index>(k) + 1]);
    }
  }
  spectrum.slow = std::max(spectrum.slow, LeastShare * shares.sum());
  if (spectrum.time.empty()) // the fit is then expected to reject the branch
  {
    spectrum.time.push_back(std::sqrt(window.shortest * window.longest));
    spectrum.strength.push_back(DefaultShare * spectrum.slow);
  }
  return spectrum;
}

RelaxingBody withSpectrum(RelaxingBody about, const RelaxationSpectrum& spectrum)
{
  about.body.reducedModulus *= spectrum.slow;
  // The shape of the curve depends on the product of C_g and E*. Therefore this product is kept
  // constant.
  about.body.compliance /= spectrum.slow;
  about.series = {};
  for (std::size_t i = 0; i < spectrum.time.size(); ++i)
  {
    about.series.add(spectrum.strength[i] / spectrum.slow, spectrum.time[i]);
  }
  return about;
}
} // namespace palpate
