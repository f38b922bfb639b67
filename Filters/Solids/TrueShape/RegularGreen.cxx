// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/RegularGreen.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/SharedWork.h"
#include "Mechanics/ThreadCount.h"
#include "Solids/TrueShape/SourceThinning.h"
#include "Solids/TrueShape/SubtractedLoad.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace palpate
{
namespace
{
/// Number of right-hand sides per solution. A solution reads the factor once for all of them.
constexpr std::size_t GreenBlock = 32;

/// Radius, in spacings, within which there are enough sources for the fit of lowest order.
constexpr double RingOfSources = 2.9;

/// Smallest ratio of the spacing of sources to the largest contact radius. Without this limit, a
/// surface with many edges would have a source at every point.
constexpr double ClosestSources = 2.0 / 3.0;

/// Returns the mean curvature at the middle of a disc, 1/mm, from the nearest points. It is > 0 if
/// the surface is convex.
double meanCurvature(const ElasticBody& body, std::int32_t point)
{
  const SurfaceDisc ring = surfaceDisc(body, point, 2.0 * body.surface().spacing(point));
  double sum = 0.0;
  double weights = 0.0;
  for (const DiscPoint& at : ring.points)
  {
    if (at.distance > 0.0)
    {
      // The weight is roughly the angle that the point covers, which is its area divided by its
      // distance.
      const double weight = at.area / at.distance;
      sum += weight * 2.0 * at.drop / (at.distance * at.distance);
      weights += weight;
    }
  }
  return weights > 0.0 ? sum / weights : 0.0;
}
} // namespace

/// Returns the index of a point in Points. Returns the size of Points if the point is not in
/// Points.
std::size_t RegularGreen::placeOf(std::int32_t point) const
{
  const auto at = std::lower_bound(this->Points.begin(), this->Points.end(), point);
  return at != this->Points.end() && *at == point
    ? static_cast<std::size_t>(at - this->Points.begin())
    : this->Points.size();
}

const SurfaceDisc* RegularGreen::disc(std::int32_t point) const
{
  const std::size_t place = this->placeOf(point);
  return place < this->Points.size() ? &this->Discs[place] : nullptr;
}

ExpectedError RegularGreen::elementError(std::int32_t point) const
{
  const std::size_t place = this->placeOf(point);
  return place < this->Points.size() ? this->Errors.at(place) : ExpectedError{};
}

/// Returns the row of a source. Returns null if the point is not a source.
const RegularGreen::Row* RegularGreen::row(std::int32_t source) const
{
  const auto at = std::lower_bound(this->Sources.begin(), this->Sources.end(), source);
  return at != this->Sources.end() && *at == source
    ? &this->Rows[static_cast<std::size_t>(at - this->Sources.begin())]
    : nullptr;
}

const double* RegularGreen::find(std::int32_t x, std::int32_t source) const
{
  const Row* row = this->row(source);
  if (row == nullptr)
  {
    return nullptr;
  }
  const auto found = std::lower_bound(row->points.begin(), row->points.end(), x);
  return found != row->points.end() && *found == x
    ? &row->values[static_cast<std::size_t>(found - row->points.begin())]
    : nullptr;
}

const Eigen::Vector3d& RegularGreen::motion(std::int32_t source) const
{
  static const Eigen::Vector3d none = Eigen::Vector3d::Constant(NotANumber);
  const Row* row = this->row(source);
  return row != nullptr ? row->motion : none;
}

bool RegularGreen::isSource(std::int32_t point) const
{
  return std::binary_search(this->Sources.begin(), this->Sources.end(), point);
}

std::vector<std::int32_t> RegularGreen::pressedSources() const
{
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    if (this->Discs[i].status == PatchStatus::Valid && this->isSource(this->Points[i]))
    {
      found.push_back(this->Points[i]);
    }
  }
  return found;
}

double RegularGreen::at(std::int32_t x, std::int32_t source) const
{
  const double* there = this->find(x, source);
  const double* back = this->find(source, x);
  return there != nullptr && back != nullptr ? 0.5 * (*there + *back)
    : there != nullptr                       ? *there
    : back != nullptr                        ? *back
                                             : NotANumber;
}

double RegularGreen::asymmetry(std::int32_t x, std::int32_t source) const
{
  const double* there = this->find(x, source);
  const double* back = this->find(source, x);
  return there != nullptr && back != nullptr ? std::abs(*there - *back) : 0.0;
}

/// Returns the radius around a point within which sources are needed. It is large enough for the
/// fit of lowest order.
double RegularGreen::discRadius(std::int32_t point) const
{
  return std::max({ DiscRatio * this->Radius, RingOfSources * this->Body.surface().spacing(point),
    RingOfSources * this->Spacing });
}

double RegularGreen::memoryForecast(
  const std::vector<std::int32_t>& points, double radius, double spacing) const
{
  // The mean size is estimated from a sample of discs. A row extends twice as far as a disc.
  constexpr std::size_t samples = 64;
  double inDisc = 0.0;
  double apart = 0.0;
  double taken = 0.0;
  for (std::size_t i = 0; i < points.size(); i += std::max<std::size_t>(1, points.size() / samples))
  {
    inDisc += static_cast<double>(
      surfaceDisc(this->Body, points[i], std::max(DiscRatio * radius, RingOfSources * spacing))
        .points.size());
    apart += this->Body.surface().spacing(points[i]);
    taken += 1.0;
  }
  const double disc = inDisc / std::max(1.0, taken);
  const double thinned = std::max(1.0, spacing * taken / std::max(apart, 1e-300));
  const auto total = static_cast<double>(this->Body.surface().pointTotal());
  const double kept = 1.0 / (thinned * thinned);
  const double sources =
    kept * std::min(total, static_cast<double>(points.size()) * std::max(1.0, disc));
  const double rows =
    sources * kept * std::min(total, 4.0 * disc) * (sizeof(double) + sizeof(std::int32_t));
  const double discs = static_cast<double>(points.size()) * disc * sizeof(DiscPoint);
  // The blocks contain the loads, the solution and CHOLMOD's permuted copies.
  const double blocks = static_cast<double>(threadCount()) * GreenBlock *
    static_cast<double>(this->Body.unknowns()) * 4.0 * sizeof(double);
  return rows + discs + blocks;
}

/// Chooses the sources. These are the points of all discs, or a thinned set of these points.
void RegularGreen::chooseSources()
{
  this->Sources.clear();
  for (const SurfaceDisc& disc : this->Discs)
  {
    for (const DiscPoint& at : disc.points)
    {
      this->Sources.push_back(at.point);
    }
  }
  std::sort(this->Sources.begin(), this->Sources.end());
  this->Sources.erase(std::unique(this->Sources.begin(), this->Sources.end()), this->Sources.end());
  if (this->Spacing > 0.0)
  {
    std::vector<double> spacings(this->Sources.size(), this->Spacing);
    shareWork(this->IsEven ? 0 : spacings.size(),
      [&](std::size_t i)
      {
        const SurfaceDisc around = surfaceDisc(this->Body, this->Sources[i], 2.0 * this->Spacing);
        spacings[i] =
          std::min(this->Spacing, std::max(ClosestSources * this->Radius, 0.5 * around.limit));
      });
    this->Sources = thinnedSources(this->Body.surface(), this->Sources, spacings);
    std::sort(this->Sources.begin(), this->Sources.end());
  }
}

/// Chooses the points at which each source must be known.
void RegularGreen::layOut()
{
  std::vector<std::vector<std::int32_t>> known(this->Discs.size());
  std::unordered_map<std::int32_t, std::vector<std::size_t>> discsOf;
  for (std::size_t i = 0; i < this->Discs.size(); ++i)
  {
    for (const DiscPoint& at : this->Discs[i].points)
    {
      if (this->isSource(at.point))
      {
        discsOf[at.point].push_back(i);
        known[i].push_back(at.point);
      }
    }
  }
  this->Rows.assign(this->Sources.size(), {});
  // Discs overlap. Each point is in a row only once, even if several discs contain it.
  std::vector<std::size_t> takenBy(static_cast<std::size_t>(this->Body.surface().pointTotal()), 0);
  for (std::size_t s = 0; s < this->Sources.size(); ++s)
  {
    std::vector<std::int32_t>& row = this->Rows[s].points;
    for (const std::size_t i : discsOf.at(this->Sources[s]))
    {
      for (const std::int32_t point : known[i])
      {
        std::size_t& taken = takenBy[static_cast<std::size_t>(point)];
        if (taken != s + 1)
        {
          taken = s + 1;
          row.push_back(point);
        }
      }
    }
    std::sort(row.begin(), row.end());
    row.shrink_to_fit();
  }
}

void RegularGreen::solveBlock(const SubtractedLoad& loads, std::size_t block)
{
  const std::size_t first = block * GreenBlock;
  const std::size_t last = std::min(this->Sources.size(), first + GreenBlock);
  const BodySurface& surface = this->Body.surface();
  Eigen::MatrixXd right(this->Body.unknowns(), static_cast<Eigen::Index>(last - first));
  for (std::size_t s = first; s < last; ++s)
  {
    right.col(static_cast<Eigen::Index>(s - first)) =
      loads.load(SingularSource(this->Body, this->Sources[s]));
  }
  const Eigen::MatrixXd smooth = this->Body.factor().solveAll(right);
  for (std::size_t s = first; s < last; ++s)
  {
    const SingularSource source(this->Body, this->Sources[s]);
    const BoussinesqField field(source.material);
    const double modulus =
      Pi * reducedModulus(source.material.youngsModulus, source.material.poissonRatio);
    Row& row = this->Rows[s];
    row.values.assign(row.points.size(), NotANumber);
    for (std::size_t i = 0; smooth.size() > 0 && i < row.points.size(); ++i)
    {
      const std::int32_t point = row.points[i];
      const std::int32_t node = surface.node(point);
      const Eigen::Vector3d at = source.inFrame(surface.position(point));
      const Eigen::Vector3d normal = source.frame.transpose() * surface.normal(point);
      Eigen::Vector3d moved = Eigen::Vector3d::Zero();
      for (int axis = 0; axis < 3; ++axis)
      {
        const int unknown = this->Body.unknown(node, axis);
        if (unknown >= 0)
        {
          moved[axis] = smooth(unknown, static_cast<Eigen::Index>(s - first));
        }
        else if (point != source.point)
        {
          moved[axis] = -source.frame.row(axis).dot(field.displacement(at));
        }
      }
      row.values[i] = -surface.normal(point).dot(moved);
      if (point != source.point)
      {
        row.values[i] += -normal.dot(field.displacement(at)) - 1.0 / (modulus * at.norm());
      }
      else
      {
        row.motion = -moved;
        const double nu = source.material.poissonRatio;
        row.values[i] +=
          (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu)) * meanCurvature(this->Body, point) / modulus;
      }
    }
  }
  const std::vector<std::int32_t> sources(
    this->Sources.begin() + static_cast<std::ptrdiff_t>(first),
    this->Sources.begin() + static_cast<std::ptrdiff_t>(last));
  const auto bendingOf = [&](std::size_t s)
  {
    const double* self = this->find(sources[s], sources[s]);
    return self == nullptr ? NotANumber : std::abs(*self) - this->elementError(sources[s]).direct;
  };
  if (smooth.size() > 0)
  {
    const BendingError::Choice choice{ block, this->Bending.size(), this->IsEven };
    this->Bending[block] = BendingError::sample(this->Body, choice, sources, smooth, bendingOf);
  }
}

void RegularGreen::expectBending()
{
  std::vector<BendingError::Sample> all;
  for (const std::vector<BendingError::Sample>& ofBlock : this->Bending)
  {
    all.insert(all.end(), ofBlock.begin(), ofBlock.end());
  }
  this->Errors.setBending(BendingError(std::move(all)), this->Body.surface(), this->Points);
}

std::string RegularGreen::solve(const std::vector<std::int32_t>& points, double radius,
  const WorkObserver& observer, double spacing, bool isEven)
{
  if (!(spacing >= 0.0) || !std::isfinite(spacing))
  {
    return joined("the spacing of sources must be finite and not negative (mm), but is ", spacing);
  }
  if (!(radius > 0.0) || !std::isfinite(radius))
  {
    return joined("the largest contact radius must be positive and finite (mm), but is ", radius);
  }
  this->Radius = radius;
  this->Spacing = spacing;
  this->IsEven = isEven;
  this->Points = points;
  std::sort(this->Points.begin(), this->Points.end());
  this->Points.erase(std::unique(this->Points.begin(), this->Points.end()), this->Points.end());
  for (const std::int32_t point : this->Points)
  {
    if (point < 0 || point >= this->Body.surface().pointTotal())
    {
      return whyNotPressed(this->Body, point);
    }
  }
  this->Discs.assign(this->Points.size(), {});
  shareWork(this->Points.size(),
    [this](std::size_t i)
    {
      this->Discs[i] = surfaceDisc(this->Body, this->Points[i], this->discRadius(this->Points[i]));
      this->Discs[i].points.shrink_to_fit();
    });
  if (std::none_of(this->Discs.begin(), this->Discs.end(),
        [](const SurfaceDisc& disc) { return disc.status == PatchStatus::Valid; }))
  {
    return this->Points.empty()
      ? "there is no point to press"
      : "no point can be pressed; the first: " + whyNotPressed(this->Body, this->Points.front());
  }
  this->Held = HeldRim(this->Body);
  this->chooseSources();
  this->layOut();
  this->Errors = SourceErrors(this->Body, this->Points, this->Discs, this->Sources);
  const SubtractedLoad loads(this->Body);
  const std::size_t blocks = (this->Sources.size() + GreenBlock - 1) / GreenBlock;
  this->Bending.assign(blocks, {});
  // The blocks do not depend on the number of threads. Therefore the results do not depend on it
  // either.
  if (!shareWork(
        blocks, [&](std::size_t block) { this->solveBlock(loads, block); }, observer))
  {
    this->Rows.clear();
    this->Sources.clear();
    return "stopped";
  }
  for (const Row& row : this->Rows)
  {
    if (!row.values.empty() && std::isnan(row.values.front()))
    {
      return "the solution for the sources does not fit the memory";
    }
  }
  this->expectBending();
  return {};
}
} // namespace palpate
