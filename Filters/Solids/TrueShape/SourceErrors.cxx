// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/SourceErrors.h"

#include "Mechanics/SharedWork.h"
#include "Solids/TrueShape/ElementError.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
/// Number of sources whose expected errors are averaged for a point that is not a source.
constexpr std::size_t ErrorSources = 3;

struct NearSource
{
  std::size_t place; ///< index of the source in the points
  double weight;
};

/// Returns the sources that determine the expected error at the middle of a disc. This is the
/// middle itself if it is a source, otherwise the nearest sources.
std::vector<NearSource> nearestSources(const SurfaceDisc& disc,
  const std::vector<std::int32_t>& points, const std::vector<std::int32_t>& sources)
{
  std::vector<NearSource> found;
  for (const DiscPoint& at : disc.points)
  {
    const auto place = std::lower_bound(points.begin(), points.end(), at.point);
    if (place == points.end() || *place != at.point ||
      !std::binary_search(sources.begin(), sources.end(), at.point))
    {
      continue;
    }
    found.push_back({ static_cast<std::size_t>(place - points.begin()),
      1.0 / std::max(at.distance * at.distance, 1e-300) });
    if (at.distance == 0.0 || found.size() == ErrorSources)
    {
      break;
    }
  }
  return found;
}
} // namespace

SourceErrors::SourceErrors(const ElasticBody& body, const std::vector<std::int32_t>& points,
  const std::vector<SurfaceDisc>& discs, const std::vector<std::int32_t>& sources)
{
  const ElementError elements(body);
  std::vector<ExpectedError> own(points.size());
  shareWork(own.size(),
    [&](std::size_t i)
    {
      const std::vector<NearSource> near = nearestSources(discs[i], points, sources);
      const bool usesOtherSources = !near.empty() && near.back().place != i;
      if (!usesOtherSources && discs[i].status == PatchStatus::Valid)
      {
        own[i] = elements.at(SingularSource(body, points[i]));
      }
    });
  this->Errors = own;
  shareWork(own.size(),
    [&](std::size_t i)
    {
      ExpectedError sum{ 0.0, 0.0 };
      double weights = 0.0;
      for (const NearSource& source : nearestSources(discs[i], points, sources))
      {
        sum.error += source.weight * own[source.place].error;
        sum.direct += source.weight * own[source.place].direct;
        weights += source.weight;
      }
      if (std::isnan(own[i].error) && weights > 0.0)
      {
        this->Errors[i] = { sum.error / weights, sum.direct / weights };
      }
    });
}

void SourceErrors::setBending(
  const BendingError& bending, const BodySurface& surface, const std::vector<std::int32_t>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    this->Errors[i].bending = bending.at(surface.position(points[i]));
  }
}
} // namespace palpate
