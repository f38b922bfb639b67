// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Curves/CurvesOnEdges.h"

#include "Contact/ResponseContract.h"
#include "Contact/ResponseSampling.h"
#include "Laws/EdgeDistance.h"
#include "Solids/FiniteElements/NearestAlong.h"
#include "Mechanics/ReducedModulus.h"
#include "Mechanics/SharedWork.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::size_t CurvesAround = 6;
constexpr double RelativeStep = 1e-3; ///< step for dF/dδ, as a fraction of the depth

/// Returns the largest angle between the triangles at a point if the surface is convex at the
/// point, rad. Returns 0 in a hollow.
double turnAt(const BodySurface& surface, std::int32_t point)
{
  Eigen::Vector3d around = Eigen::Vector3d::Zero();
  double turn = 0.0;
  for (const std::int32_t* t = surface.trianglesBegin(point); t != surface.trianglesEnd(point); ++t)
  {
    for (const std::int32_t corner : surface.triangle(*t))
    {
      around += surface.position(corner) - surface.position(point);
    }
    for (const std::int32_t* other = surface.trianglesBegin(point); other != t; ++other)
    {
      turn = std::max(turn,
        std::acos(
          std::clamp(surface.triangleNormal(*t).dot(surface.triangleNormal(*other)), -1.0, 1.0)));
    }
  }
  return around.dot(surface.normal(point)) < 0.0 ? turn : 0.0;
}

class EdgeFiller
{
public:
  EdgeFiller(
    const EdgedSurface& surface, const ResponseSampling& sampling, const ResponseSpans& spans)
    : Surface(surface)
    , Sampling(sampling)
    , Spans(spans)
  {
  }

  void fill(std::int32_t point) const
  {
    const auto i = static_cast<std::size_t>(point);
    const auto n = static_cast<std::size_t>(this->Spans.samples);
    Neighbours around;
    const EdgeSurroundings there = this->Surface.around(
      point, [this](std::int32_t other) { return this->isValid(static_cast<std::size_t>(other)); });
    around.found = there.found;
    around.weights = weightsAlong(around.found);
    around.poissonRatio = this->Surface.materialAt(point).poissonRatio;
    around.sharpness = edgeSharpness(around.poissonRatio, there.turn);
    double range = 0.0;
    for (std::size_t k = 0; k < around.found.size(); ++k)
    {
      range += around.weights[k] *
        static_cast<double>(this->Spans.range[static_cast<std::size_t>(around.found[k].point)]);
    }
    this->Spans.range[i] = static_cast<float>(range);
    this->Spans.validity[i] = 0.0F;
    this->Spans.limit[i] = static_cast<unsigned char>(ResponseLimit::Edge);
    for (std::size_t k = 0; k < n && range > 0.0; ++k)
    {
      const double depth = this->Sampling.depth(static_cast<int>(k), range);
      const double step = RelativeStep * depth;
      this->Spans.force[n * i + k] = static_cast<float>(this->force(around, depth));
      this->Spans.stiffness[n * i + k] = static_cast<float>(
        (this->force(around, depth + step) - this->force(around, depth - step)) / (2.0 * step));
      if (this->Spans.error)
      {
        this->Spans.error[n * i + k] = 1.0F;
      }
    }
  }

  bool isEdge(std::size_t i) const { return this->is(i, ResponseStatus::Edge); }

private:
  /// The valid points around a point on an edge.
  struct Neighbours
  {
    std::vector<AlongSurface> found;
    std::vector<double> weights;
    double poissonRatio = 0.0;
    double sharpness = 0.0;
  };

  bool is(std::size_t i, ResponseStatus status) const
  {
    return this->Spans.status[i] == static_cast<unsigned char>(status);
  }
  bool isValid(std::size_t i) const { return this->is(i, ResponseStatus::Valid); }

  double force(const Neighbours& around, double depth) const
  {
    const auto n = static_cast<std::size_t>(this->Spans.samples);
    double sum = 0.0;
    for (std::size_t k = 0; k < around.found.size(); ++k)
    {
      const std::int32_t other = around.found[k].point;
      const auto j = static_cast<std::size_t>(other);
      const ResponseValue value = this->Sampling.evaluate(
        FloatCurve{ this->Spans.force + n * j, this->Spans.stiffness + n * j },
        static_cast<double>(this->Spans.range[j]), depth);
      const ElasticMaterial material = this->Surface.materialAt(other);
      const double modulus = reducedModulus(material.youngsModulus, material.poissonRatio);
      const double radius = std::max(value.stiffness / (2.0 * modulus), 1e-300);
      sum += around.weights[k] * value.force *
        edgeFactor(around.poissonRatio, 0.0, around.sharpness) /
        edgeFactor(around.poissonRatio, around.found[k].distance / radius, around.sharpness);
    }
    return sum;
  }

  const EdgedSurface& Surface;
  const ResponseSampling& Sampling;
  const ResponseSpans& Spans;
};
} // namespace

EdgedSurface edgesOf(const ElasticBody& body)
{
  EdgedSurface made;
  made.points = static_cast<std::size_t>(body.surface().pointTotal());
  made.materialAt = [&body](std::int32_t point)
  { return body.materialAt(body.surface().node(point)); };
  made.around = [&body](std::int32_t point, const std::function<bool(std::int32_t)>& isValid)
  {
    return EdgeSurroundings{ nearestAlong(body.surface(), point, CurvesAround, isValid),
      turnAt(body.surface(), point) };
  };
  return made;
}

void fillEdges(
  const EdgedSurface& surface, const ResponseSampling& sampling, const ResponseSpans& spans)
{
  const EdgeFiller filler(surface, sampling, spans);
  // Points on edges use only valid points. Therefore they do not depend on each other.
  shareWork(surface.points,
    [&filler](std::size_t i)
    {
      if (filler.isEdge(i))
      {
        filler.fill(static_cast<std::int32_t>(i));
      }
    });
}
} // namespace palpate
