// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/BendingError.h"

#include "Solids/FiniteElements/EnergyError.h"
#include "Solids/TrueShape/SubtractedLoad.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t SampledBlocks = 12;
/// Number of sources that are used from each sampled block.
constexpr std::size_t SourcesPerBlock = 16;

/// Number of nearest samples that have the same weight in the median around a position.
constexpr std::size_t NearestOfMedian = 8;
constexpr double LargestOverMedian = 3.0;
} // namespace

std::vector<BendingError::Sample> BendingError::sample(const ElasticBody& body,
  const Choice& choice, const std::vector<std::int32_t>& sources, const Eigen::MatrixXd& smooth,
  const BendingOf& bendingOf)
{
  std::vector<Sample> samples;
  if (choice.block % std::max<std::size_t>(1, choice.blocks / SampledBlocks) != 0)
  {
    return samples;
  }
  std::vector<std::pair<std::size_t, double>> bent;
  for (std::size_t s = 0; s < sources.size(); ++s)
  {
    const double bending = bendingOf(s);
    if (bending > 0.0)
    {
      bent.emplace_back(s, bending);
    }
  }
  std::vector<Eigen::Matrix3Xd> moved;
  const std::size_t most = choice.isCoarse ? SourcesPerBlock / 4 : SourcesPerBlock;
  const std::size_t step = std::max<std::size_t>(1, bent.size() / most);
  for (std::size_t k = 0; k < bent.size() && moved.size() < most; k += step)
  {
    const auto& [s, bending] = bent[k];
    const SingularSource source(body, sources[s]);
    moved.push_back(regularDisplacement(body, source, smooth.col(static_cast<Eigen::Index>(s))));
    samples.push_back({ source.origin, bending, 0.0 });
  }
  if (samples.empty())
  {
    return samples; // without this return, energyErrors() would visit every element
  }
  const std::vector<double> energies = energyErrors(body, moved);
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    samples[k].energy = energies[k];
  }
  return samples;
}

BendingError::BendingError(std::vector<Sample> samples)
  : Samples(std::move(samples))
{
}

/// Returns the weighted median of e divided by bending. The weight is the bending divided by the
/// squared distance. In this weight, the nearest samples (NearestOfMedian) have the same distance.
double BendingError::medianAround(const std::vector<double>& squares) const
{
  std::vector<double> nearest = squares;
  const auto last = static_cast<std::ptrdiff_t>(std::min(NearestOfMedian, nearest.size())) - 1;
  std::nth_element(nearest.begin(), nearest.begin() + last, nearest.end());
  const double alike = nearest[static_cast<std::size_t>(last)];
  std::vector<std::pair<double, double>> weighted; // ratios e / bending, and their weights
  double total = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    const Sample& sample = this->Samples[i];
    const double weight = sample.bending / std::max(squares[i], alike);
    weighted.emplace_back(sample.energy / sample.bending, weight);
    total += weight;
  }
  std::sort(weighted.begin(), weighted.end());
  double median = 0.0;
  double below = 0.0;
  for (const auto& [ratio, weight] : weighted)
  {
    median = ratio;
    below += weight;
    if (below >= 0.5 * total)
    {
      break;
    }
  }
  return median;
}

double BendingError::at(const Eigen::Vector3d& place) const
{
  if (this->Samples.empty())
  {
    return Assumed;
  }
  std::vector<double> squares; // squared distances of the samples from `place`, mm²
  for (const Sample& sample : this->Samples)
  {
    squares.push_back(std::max((sample.place - place).squaredNorm(), 1e-300));
  }
  const double most = LargestOverMedian * this->medianAround(squares);
  double bends = 0.0;
  double missed = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    const Sample& sample = this->Samples[i];
    if (sample.energy > most * sample.bending)
    {
      continue;
    }
    const double weight = 1.0 / squares[i];
    bends += weight * sample.bending;
    missed += weight * BoundOfEnergy * sample.energy;
  }
  // The smoothed stresses do not represent the fraction x of the missed part either, and so on. The
  // total is the series x + x² + ...
  return missed < bends ? std::clamp(missed / (bends - missed), Least, Most) : Most;
}
} // namespace palpate
