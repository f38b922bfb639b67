// SPDX-License-Identifier: BSD-3-Clause
#include "Identification/CommonRelaxation.h"

#include "Identification/RelaxationStart.h"
#include "Mechanics/Numerics/NonNegativeLeastSquares.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Index;

constexpr double MergeRatio = 2.0;  // times whose ratio is smaller are merged
constexpr int PointsPerDecade = 10; // number of times per decade at which ψ is compared
// ψ is compared from (shortest τ)/TimeMargin to TimeMargin (longest τ).
constexpr double TimeMargin = 5.0;

/// Returns all branches of the sites, sorted by their times.
RelaxationSpectrum gather(const std::vector<const IdentifiedBody*>& sites)
{
  std::vector<std::pair<double, double>> branches;
  for (const IdentifiedBody* site : sites)
  {
    for (std::size_t i = 0; i < site->relaxation.count; ++i)
    {
      branches.emplace_back(site->relaxation.time[i], site->relaxation.strength[i]);
    }
  }
  std::sort(branches.begin(), branches.end());
  RelaxationSpectrum spectrum;
  for (const auto& [time, strength] : branches)
  {
    if (strength > 0.0)
    {
      spectrum.time.push_back(time);
      spectrum.strength.push_back(strength);
    }
  }
  return spectrum;
}

double closestRatio(const RelaxationSpectrum& spectrum)
{
  double least = MergeRatio;
  for (std::size_t i = 0; i + 1 < spectrum.time.size(); ++i)
  {
    least = std::min(least, spectrum.time[i + 1] / spectrum.time[i]);
  }
  return least;
}
} // namespace

CommonRelaxation commonRelaxation(const std::vector<const IdentifiedBody*>& sites)
{
  CommonRelaxation common;
  common.strength.resize(sites.size());
  if (sites.size() == 1)
  {
    common.mean = sites.front()->relaxation;
    common.strength.front() = common.mean.strength;
    return common;
  }
  RelaxationSpectrum spectrum = gather(sites);
  while (spectrum.time.size() > PronySeries::LargestCount || closestRatio(spectrum) < MergeRatio)
  {
    spectrum = spectrum.merged(spectrum.time.size() - 1);
  }
  const auto branches = static_cast<Index>(spectrum.time.size());
  if (branches == 0)
  {
    return common;
  }
  for (const double time : spectrum.time)
  {
    common.mean.add(0.0, time);
  }
  for (std::size_t s = 0; s < sites.size(); ++s)
  {
    const PronySeries& own = sites[s]->relaxation;
    if (!own.relaxes())
    {
      continue;
    }
    const double first = std::min(own.time[0], spectrum.time.front()) / TimeMargin;
    const double last = std::max(own.time[own.count - 1], spectrum.time.back()) * TimeMargin;
    const auto points = static_cast<Index>(PointsPerDecade * std::log10(last / first)) + 1;
    Eigen::MatrixXd columns(points, branches);
    Eigen::VectorXd wanted(points);
    for (Index i = 0; i < points; ++i)
    {
      const double t = first * std::pow(10.0, static_cast<double>(i) / PointsPerDecade);
      for (Index k = 0; k < branches; ++k)
      {
        columns(i, k) = std::exp(-t / spectrum.time[static_cast<std::size_t>(k)]);
      }
      wanted[i] = relaxationAt(own, t) - 1.0;
    }
    const Eigen::VectorXd found = nonNegativeLeastSquares(columns, wanted);
    const Eigen::VectorXd missed =
      (columns * found - wanted).cwiseQuotient((wanted.array() + 1.0).matrix());
    common.worst = std::max(common.worst, missed.cwiseAbs().maxCoeff());
    for (std::size_t k = 0; k < spectrum.time.size(); ++k)
    {
      common.strength[s][k] = found[static_cast<Index>(k)];
      common.mean.strength[k] += found[static_cast<Index>(k)] / static_cast<double>(sites.size());
    }
  }
  return common;
}
} // namespace palpate
