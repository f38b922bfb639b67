// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/TrueShape/MeshDifference.h"

#include "Mechanics/SharedWork.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Landmarks whose kernels are blended to one at a place.
constexpr std::size_t BlendedLandmarks = 6;
constexpr double FacingCosine = 0.5; ///< those that face the same way: within 60°

/// Of the spacing of the coarser mesh: how far around a place its landmarks are taken.
constexpr double ReachOfMean = 3.0;
constexpr std::size_t LeastOfMean = 6; ///< or as far as so many of them are
/// Times what second order leaves.
constexpr double Safety = 2.0;
constexpr double LeastRatio = 1.25; ///< k; below it a difference of meshes tells little
constexpr double LeastPart = 5e-4; ///< of c₀₀

/// Places of those that face the same way, nearest first, no more than `count`.
template <class Positions>
std::vector<std::pair<double, std::size_t>> nearestFacing(const Positions& landmarkAt,
  std::size_t total, const Eigen::Vector3d& place, const Eigen::Vector3d& normal)
{
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t i = 0; i < total; ++i)
  {
    const auto [at, outward] = landmarkAt(i);
    if (outward.dot(normal) >= FacingCosine)
    {
      found.emplace_back((at - place).squaredNorm(), i);
    }
  }
  return found;
}
} // namespace

double MissedCompliance::at(double radius) const
{
  const auto above = std::upper_bound(this->radii.begin(), this->radii.end(), radius);
  if (above == this->radii.begin())
  {
    return this->values.front();
  }
  if (above == this->radii.end())
  {
    return this->values.back();
  }
  const auto high = static_cast<std::size_t>(above - this->radii.begin());
  const double part = std::log(radius / this->radii[high - 1]) /
    std::log(this->radii[high] / this->radii[high - 1]);
  return (1.0 - part) * this->values[high - 1] + part * this->values[high];
}

MeshDifference::MeshDifference(const LandmarkKernels& body, const LandmarkKernels& coarser)
  : Radii(body.radii())
{
  const BodySurface& surface = body.green().body().surface();
  const BodySurface& coarseSurface = coarser.green().body().surface();
  this->Samples.resize(coarser.points().size());
  shareWork(this->Samples.size(),
    [&](std::size_t i)
    {
      Sample& sample = this->Samples[i];
      const std::int32_t point = coarser.points()[i];
      sample.place = coarseSurface.position(point);
      sample.normal = coarseSurface.normal(point);
      sample.missed.assign(this->Radii.size(), NotANumber);
      const BlendedKernels there(coarser, { sample.place, sample.normal, {} }, { i });
      auto near = nearestFacing(
        [&](std::size_t k)
        {
          const std::int32_t other = body.points()[k];
          return std::pair<const Eigen::Vector3d&, const Eigen::Vector3d&>(
            surface.position(other), surface.normal(other));
        },
        body.points().size(), sample.place, sample.normal);
      const std::size_t taken = std::min(BlendedLandmarks, near.size());
      std::partial_sort(
        near.begin(), near.begin() + static_cast<std::ptrdiff_t>(taken), near.end());
      std::vector<std::size_t> around;
      for (std::size_t k = 0; k < taken; ++k)
      {
        around.push_back(near[k].second);
      }
      const BlendedKernels here(body, { sample.place, sample.normal, {} }, around);
      sample.spacing = there.site().spacing;
      if (here.site().status != PatchStatus::Valid || there.site().status != PatchStatus::Valid)
      {
        return;
      }
      const double ratio = std::max(LeastRatio, sample.spacing / here.site().spacing);
      double last = NotANumber;
      for (std::size_t r = 0; r < this->Radii.size(); ++r)
      {
        if (r == 0 || this->Radii[r] <= std::min(here.site().limit, there.site().limit))
        {
          const double self = here.at(this->Radii[r]).coefficients(0, 0);
          const double other = there.at(this->Radii[r]).coefficients(0, 0);
          last = std::hypot(
            Safety * (self - other) / (ratio * ratio - 1.0), LeastPart * self);
        }
        sample.missed[r] = last;
      }
    });
}

MissedCompliance MeshDifference::at(
  const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const
{
  auto near = nearestFacing(
    [this](std::size_t i)
    {
      return std::pair<const Eigen::Vector3d&, const Eigen::Vector3d&>(
        this->Samples[i].place, this->Samples[i].normal);
    },
    this->Samples.size(), place, normal);
  near.erase(std::remove_if(near.begin(), near.end(),
               [this](const auto& at) { return std::isnan(this->Samples[at.second].missed[0]); }),
    near.end());
  MissedCompliance told;
  if (near.empty())
  {
    return told;
  }
  const std::size_t least = std::min(LeastOfMean, near.size()) - 1;
  std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(least), near.end());
  const auto nearest = std::min_element(near.begin(), near.end());
  const double reach = ReachOfMean * this->Samples[nearest->second].spacing;
  const double square = std::max(reach * reach, 2.0 * near[least].first);
  std::sort(near.begin(), near.end());
  told.radii = this->Radii;
  told.values.assign(this->Radii.size(), 0.0);
  double weights = 0.0;
  for (const auto& [distance, i] : near)
  {
    if (distance >= square)
    {
      break;
    }
    const double weight = (1.0 - distance / square) * (1.0 - distance / square);
    weights += weight;
    for (std::size_t r = 0; r < told.values.size(); ++r)
    {
      told.values[r] += weight * this->Samples[i].missed[r] * this->Samples[i].missed[r];
    }
  }
  for (double& value : told.values)
  {
    value = std::sqrt(value / weights);
  }
  return told;
}
} // namespace palpate
