// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/MeshDifference.h"

#include "Mechanics/SharedWork.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace palpate
{
namespace
{
/// Number of landmarks that are blended to a kernel at a position.
constexpr std::size_t BlendedLandmarks = 6;
constexpr double FacingCosine = 0.5; ///< cosine of 60°, for normals that count as similar

/// Radius around a position within which landmarks of the coarser mesh are used, in spacings of its
/// nodes.
constexpr double ReachOfMean = 2.0;
/// Smallest number of landmarks. If fewer are within the radius, a larger radius is used.
constexpr std::size_t LeastOfMean = 6;
/// Factor on the squared distance of the last of these landmarks. It keeps the weight of this
/// landmark above zero.
constexpr double LastDistanceFactor = 2.0;
/// Smallest ratio k of the spacings. With a smaller ratio, the difference of the meshes is
/// unreliable.
constexpr double LeastRatio = 1.25;
constexpr double LeastPart = 5e-4; ///< smallest error, as a fraction of c₀₀

/// A landmark with a similar normal: its squared distance and its index.
using Facing = std::pair<double, std::size_t>;

/// Returns the indices of those of `total` surface points whose normals are similar to `normal`,
/// with their squared distances from `place`. The `nearest` nearest of them come first, sorted by
/// distance. `placeAt` and `normalAt` return the position and the normal of a point.
template <class PlaceAt, class NormalAt>
std::vector<Facing> facingAround(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
  std::size_t total, std::size_t nearest, const PlaceAt& placeAt, const NormalAt& normalAt)
{
  std::vector<Facing> facing;
  for (std::size_t i = 0; i < total; ++i)
  {
    if (normalAt(i).dot(normal) >= FacingCosine)
    {
      facing.emplace_back((placeAt(i) - place).squaredNorm(), i);
    }
  }
  const auto sorted = static_cast<std::ptrdiff_t>(std::min(nearest, facing.size()));
  std::partial_sort(facing.begin(), facing.begin() + sorted, facing.end());
  return facing;
}

/// Returns the landmarks near a position on the surface, nearest first.
std::vector<std::size_t> landmarksAround(
  const LandmarkKernels& landmarks, const Eigen::Vector3d& place, const Eigen::Vector3d& normal)
{
  const BodySurface& surface = landmarks.green().body().surface();
  const std::vector<std::int32_t>& points = landmarks.points();
  const std::vector<Facing> facing = facingAround(
    place, normal, points.size(), BlendedLandmarks,
    [&](std::size_t i) { return surface.position(points[i]); },
    [&](std::size_t i) { return surface.normal(points[i]); });
  std::vector<std::size_t> around;
  for (std::size_t k = 0; k < std::min(BlendedLandmarks, facing.size()); ++k)
  {
    around.push_back(facing[k].second);
  }
  return around;
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
  const double part =
    std::log(radius / this->radii[high - 1]) / std::log(this->radii[high] / this->radii[high - 1]);
  return (1.0 - part) * this->values[high - 1] + part * this->values[high];
}

double MissedCompliance::beside(double expected, double radius) const
{
  const double told = this->at(radius);
  const double both = std::hypot(expected, told);
  return both > 0.0 ? std::sqrt(2.0) * expected * told / both : 0.0;
}

MeshDifference::MeshDifference(const LandmarkKernels& body, const LandmarkKernels& coarser)
  : Radii(body.radii())
{
  std::vector<Sample> all(coarser.points().size());
  shareWork(all.size(), [&](std::size_t i) { all[i] = this->sample(body, coarser, i); });
  std::copy_if(all.begin(), all.end(), std::back_inserter(this->Samples),
    [](const Sample& sample) { return !sample.missed.empty(); });
}

/// Returns the sample at landmark i of the coarser mesh. The sample is empty unless both meshes
/// have a kernel at the landmark.
MeshDifference::Sample MeshDifference::sample(
  const LandmarkKernels& body, const LandmarkKernels& coarser, std::size_t i) const
{
  const BodySurface& surface = coarser.green().body().surface();
  const std::int32_t point = coarser.points()[i];
  Sample sample{ surface.position(point), surface.normal(point), 0.0, {} };
  const SurfaceSpot spot{ sample.place, sample.normal, {} };
  const BlendedKernels there(coarser, spot, { i });
  const BlendedKernels here(body, spot, landmarksAround(body, sample.place, sample.normal));
  if (here.site().status != PatchStatus::Valid || there.site().status != PatchStatus::Valid)
  {
    return sample;
  }
  sample.spacing = there.site().spacing;
  const double ratio = std::max(LeastRatio, sample.spacing / here.site().spacing);
  const double known = std::min(here.site().limit, there.site().limit);
  for (const double radius : this->Radii)
  {
    if (!sample.missed.empty() && radius > known)
    {
      sample.missed.push_back(sample.missed.back());
      continue;
    }
    const double self = here.at(radius).coefficients(0, 0);
    const double other = there.at(radius).coefficients(0, 0);
    sample.missed.push_back(std::hypot((self - other) / (ratio - 1.0), LeastPart * self));
  }
  return sample;
}

MissedCompliance MeshDifference::at(
  const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const
{
  const std::vector<Facing> facing = facingAround(
    place, normal, this->Samples.size(), LeastOfMean,
    [this](std::size_t i) -> const Eigen::Vector3d& { return this->Samples[i].place; },
    [this](std::size_t i) -> const Eigen::Vector3d& { return this->Samples[i].normal; });
  MissedCompliance told;
  if (facing.empty())
  {
    return told;
  }
  const std::size_t least = std::min(LeastOfMean, facing.size());
  const double reach = ReachOfMean * this->Samples[facing.front().second].spacing;
  const double square = std::max(reach * reach, LastDistanceFactor * facing[least - 1].first);
  told.radii = this->Radii;
  told.values.assign(this->Radii.size(), 0.0);
  double weights = 0.0;
  for (const auto& [distance, i] : facing)
  {
    const double left = std::max(0.0, 1.0 - distance / square);
    for (std::size_t r = 0; left > 0.0 && r < told.values.size(); ++r)
    {
      told.values[r] += left * left * this->Samples[i].missed[r] * this->Samples[i].missed[r];
    }
    weights += left * left;
  }
  for (double& value : told.values)
  {
    value = std::sqrt(value / weights);
  }
  return told;
}
} // namespace palpate
