// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/LandmarkKernels.h"

#include "Solids/FiniteElements/PatchLoad.h"
#include "Mechanics/SharedWork.h"
#include "Solids/TrueShape/ContactKernelFit.h"
#include "Solids/TrueShape/DirectedCompliance.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::size_t RadiusCount = 17;

/// Largest distance of a limit, in units of the largest contact radius. A limit at a larger
/// distance is ignored.
constexpr double FarLimit = 2.0;

/// Limits for the plane through landmarks: the smallest allowed ratio of the smaller to the larger
/// spread of the landmarks, and the largest allowed sum of the absolute weights. If the plane
/// violates a limit, the mean is used.
constexpr double LeastSpreadOfPlane = 0.02;
constexpr double LargestWeights = 3.0;
/// Term that is added to the square of the distance relative to the mean distance.
constexpr double NearLandmark = 1e-3;

/// Converts coefficients of powers of r/from to coefficients of powers of r/to.
Eigen::Matrix4d rescaled(const Eigen::Matrix4d& c, double from, double to)
{
  const double square = (to / from) * (to / from);
  const Eigen::Vector4d powers(1.0, square, square * square, square * square * square);
  return powers.asDiagonal() * c * powers.asDiagonal();
}
} // namespace

LandmarkKernels::LandmarkKernels(const RegularGreen& green, const WorkObserver& observer)
  : Green(green)
{
  for (std::size_t k = 0; k < RadiusCount; ++k)
  {
    const double left = static_cast<double>(RadiusCount - 1 - k) / (RadiusCount - 1.0);
    this->Radii.push_back(green.radius() * std::pow(ContactKernels::FirstRadius, left));
  }
  this->Points = green.pressedSources();
  this->Landmarks.resize(this->Points.size());
  const auto fitOne = [this](std::size_t i)
  {
    const ContactKernelFit fit(this->Green, this->Points[i]);
    Landmark& made = this->Landmarks[i];
    made.site = fit.site();
    const Eigen::Matrix<double, 3, 2> tangents =
      tangentFrame(this->Green.body().surface().normal(this->Points[i])).leftCols<2>();
    for (const double radius : this->Radii)
    {
      const ContactKernel full = fit.at(radius);
      const ContactKernel coarse = full.order > 1 ? fit.at(radius, full.order - 1) : full;
      made.entries.push_back({ full.coefficients, coarse.coefficients, tangents * full.tilt,
        full.normal, coarse.normal, full.order });
    }
  };
  this->Complete = shareWork(this->Points.size(), fitOne, observer);
}

BlendedKernels::BlendedKernels(
  const LandmarkKernels& landmarks, const SurfaceSpot& spot, const std::vector<std::size_t>& around)
  : Radii(&landmarks.Radii)
  , Gap(spot.gap)
  , Tangents(tangentFrame(spot.normal).leftCols<2>())
{
  this->Site.status = PatchStatus::OutOfReach;
  std::vector<std::size_t> alike;
  for (const std::size_t i : around)
  {
    const KernelSite& site = landmarks.Landmarks[i].site;
    if (site.status == PatchStatus::Valid &&
      (alike.empty() ||
        isNearlyAlike(site.material, landmarks.Landmarks[alike.front()].site.material)))
    {
      alike.push_back(i);
    }
  }
  if (alike.empty())
  {
    return;
  }
  const Weights weights = weigh(landmarks, spot, alike);
  this->blendSites(landmarks, spot, weights, alike);
  this->blendKernels(landmarks, weights, alike, spot.normal);
  if (!this->Gap.isWhole() && this->Gap.reach() < this->Site.largestRadius)
  {
    this->Site.largestRadius = this->Gap.reach();
    this->Site.limitedBy = PatchStatus::Edge;
  }
}

BlendedKernels::Weights BlendedKernels::weigh(
  const LandmarkKernels& landmarks, const SurfaceSpot& spot, const std::vector<std::size_t>& around)
{
  const auto count = static_cast<Eigen::Index>(around.size());
  const BodySurface& surface = landmarks.green().body().surface();
  const Eigen::Matrix3d frame = tangentFrame(spot.normal);
  Weights w;
  w.near.resize(count);
  w.positions.resize(2, count);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const std::int32_t point = landmarks.Points[around[static_cast<std::size_t>(k)]];
    const Eigen::Vector3d away = surface.position(point) - spot.place;
    w.near[k] = away.norm();
    w.positions.col(k) = (frame.transpose() * away).head<2>();
  }
  const double scale = w.near.mean() + 1e-300;
  // The weight at a landmark itself is finite. Therefore the neighbours of the landmark still
  // determine the plane.
  w.near = ((w.near / scale).array().square() + NearLandmark).inverse();
  w.near /= w.near.sum();
  w.plane = Eigen::Matrix3Xd::Zero(3, count);
  w.plane.row(0) = w.near.transpose();
  Eigen::Matrix3Xd terms(3, count);
  terms.row(0).setOnes();
  terms.bottomRows<2>() = w.positions / scale;
  const Eigen::Matrix3d products = terms * w.near.asDiagonal() * terms.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(products);
  if (spread.eigenvalues()[0] < LeastSpreadOfPlane * spread.eigenvalues()[2])
  {
    return w;
  }
  Eigen::Matrix3Xd plane = products.inverse() * terms * w.near.asDiagonal();
  if (plane.row(0).lpNorm<1>() < LargestWeights)
  {
    plane.bottomRows<2>() /= scale;
    w.plane = plane;
  }
  return w;
}

void BlendedKernels::blendSites(const LandmarkKernels& landmarks, const SurfaceSpot& spot,
  const Weights& w, const std::vector<std::size_t>& around)
{
  const double largest = landmarks.green().radius();
  const KernelSite& nearest = landmarks.Landmarks[around.front()].site;
  const auto blend = [&](const auto& valueOf)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < around.size(); ++k)
    {
      sum +=
        w.plane(0, static_cast<Eigen::Index>(k)) * valueOf(landmarks.Landmarks[around[k]].site);
    }
    return std::max(0.0, sum);
  };
  this->Site = nearest;
  this->Site.limit =
    blend([&](const KernelSite& site) { return std::min(site.limit, FarLimit * largest); });
  PatchStatus by = nearest.limitedBy == PatchStatus::Valid ? PatchStatus::Edge : nearest.limitedBy;
  this->Site.toHeld = landmarks.green().held().distance(spot.place, spot.normal);
  if (this->Site.toHeld < this->Site.limit)
  {
    this->Site.limit = this->Site.toHeld;
    by = PatchStatus::OutOfReach;
  }
  this->Site.largestRadius = std::min(largest, this->Site.limit);
  this->Site.limitedBy = this->Site.limit < largest ? by : PatchStatus::Valid;
  if (this->Site.limit == 0.0 && by == PatchStatus::OutOfReach)
  {
    this->Site.status = by; // the position is inside the held part of the surface
  }
  this->Site.nearestSource = 0.0;
  this->Site.spacing = blend([](const KernelSite& site) { return site.spacing; });
  this->Site.elements = { blend([](const KernelSite& site) { return site.elements.error; }),
    blend([](const KernelSite& site) { return site.elements.direct; }),
    blend([](const KernelSite& site) { return site.elements.bending; }) };
}

void BlendedKernels::blendKernels(const LandmarkKernels& landmarks, const Weights& w,
  const std::vector<std::size_t>& around, const Eigen::Vector3d& normal)
{
  this->Blends.resize(this->Radii->size());
  const auto count = static_cast<Eigen::Index>(around.size());
  Eigen::Matrix3Xd normals(3, count);
  Eigen::Matrix3Xd motions(3, count);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const std::int32_t point = landmarks.Points[around[static_cast<std::size_t>(k)]];
    normals.col(k) = landmarks.green().body().surface().normal(point);
    motions.col(k) = landmarks.green().motion(point);
  }
  const DirectedCompliance region(normals, motions, w.near);
  this->Site.directed = region.inFrame(tangentFrame(normal));
  const double here = region.along(normal);
  Eigen::VectorXd selves(count);
  for (std::size_t r = 0; r < this->Blends.size(); ++r)
  {
    LandmarkKernels::Entry& sum = this->Blends[r].entry;
    for (std::size_t k = 0; k < around.size(); ++k)
    {
      const LandmarkKernels::Entry& entry = landmarks.Landmarks[around[k]].entries[r];
      const auto column = static_cast<Eigen::Index>(k);
      const double weight = w.plane(0, column);
      const double turned = here - region.along(entry.normal);
      sum.full += weight * entry.full;
      sum.full(0, 0) += weight * turned;
      sum.coarse += weight * entry.coarse;
      sum.coarse(0, 0) += weight * (here - region.along(entry.coarseNormal));
      sum.tilt += weight * entry.tilt;
      sum.order = std::max(sum.order, entry.order);
      selves[column] = entry.full(0, 0) + turned;
    }
    const Eigen::Vector3d plane = w.plane * selves;
    const Eigen::VectorXd left =
      (selves.array() - plane[0]).matrix() - w.positions.transpose() * plane.tail<2>();
    this->Blends[r].spread = std::sqrt(w.near.dot(left.cwiseAbs2()));
  }
}

ContactKernel BlendedKernels::at(double radius, int largestOrder) const
{
  ContactKernel kernel;
  if (this->Site.status != PatchStatus::Valid || !(radius > 0.0) || !std::isfinite(radius))
  {
    return kernel;
  }
  const std::vector<double>& radii = *this->Radii;
  const auto above = std::upper_bound(radii.begin(), radii.end(), radius) - radii.begin();
  const auto high = static_cast<std::size_t>(
    std::clamp<std::ptrdiff_t>(above, 1, static_cast<std::ptrdiff_t>(radii.size()) - 1));
  const std::size_t low = high - 1;
  const double part =
    std::clamp(std::log(radius / radii[low]) / std::log(radii[high] / radii[low]), 0.0, 1.0);
  const Blend& below = this->Blends[low];
  const Blend& beyond = this->Blends[high];
  const auto between = [part](double a, double b) { return (1.0 - part) * a + part * b; };
  kernel.order = std::max(below.entry.order, beyond.entry.order);
  const bool isCoarse = largestOrder < kernel.order;
  kernel.order -= isCoarse ? 1 : 0;
  kernel.coefficients =
    (1.0 - part) * rescaled(isCoarse ? below.entry.coarse : below.entry.full, radii[low], radius) +
    part * rescaled(isCoarse ? beyond.entry.coarse : beyond.entry.full, radii[high], radius);
  kernel.tilt =
    this->Tangents.transpose() * ((1.0 - part) * below.entry.tilt + part * beyond.entry.tilt);
  kernel.spread = between(below.spread, beyond.spread);
  kernel.gap = this->Gap.at(radius);
  return kernel;
}
} // namespace palpate
