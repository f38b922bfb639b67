// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Relaxation/BodyRelaxation.h"

#include "Contact/MeshOrder.h"
#include "Contact/ParallelRanges.h"
#include "Contact/Relaxation/ForceNodes.h"
#include "Mechanics/Numerics/IncreasingRoot.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace palpate
{
namespace
{
/// Solves d - C F(d) = local. Returns the depth d on the whole curve (local part and compliance C
/// in series) at which the local part has the depth `local`.
double wholeDepth(const ResponseField& whole, std::int32_t point, double compliance, double local)
{
  return increasingRoot(
    [&](double depth) -> ValueAndSlope
    {
      const ResponseValue value = whole.evaluate(point, depth);
      return { depth - compliance * value.force - local, 1.0 - compliance * value.stiffness };
    },
    local, whole.range(point), local + compliance * whole.evaluate(point, local).force);
}

/// Returns whether the stiffness of a curve never decreases with depth, except for noise.
bool isConvex(const ResponseField& curves, std::int32_t point)
{
  constexpr int chords = 16;
  constexpr double noise = 0.01; // largest noise, as a fraction of the slope of the steepest chord
  const double range = curves.range(point);
  double depth = 0.0;
  double force = 0.0;
  double slope = 0.0;
  double steepest = 0.0;
  double falls = 0.0;
  for (int j = 1; j <= chords; ++j)
  {
    const double share = static_cast<double>(j) / chords;
    const double next = range * (share * share);
    const double forceThere = curves.evaluate(point, next).force;
    const double chord = (forceThere - force) / (next - depth);
    falls += j > 1 ? std::max(slope - chord, 0.0) : 0.0;
    steepest = std::max(steepest, chord);
    depth = next;
    force = forceThere;
    slope = chord;
  }
  return falls <= noise * steepest;
}
} // namespace

BodyRelaxation::BodyRelaxation(
  const PackedMesh& mesh, const ResponseField& response, const ResponseArrays& arrays)
  : Whole(response)
  , Series(arrays.relaxation.series)
  , Strength(inMeshOrder(arrays.relaxation.isPerPoint() ? arrays.relaxation.strength : nullptr,
      this->Series.count, mesh))
  , Compliance(inMeshOrder(arrays.relaxation.elasticCompliance, 1, mesh))
  , Exponent(arrays.relaxation.exponent)
  , Radius(arrays.relaxation.radius)
  , Range(arrays.longestRange())
{
  if (std::any_of(
        this->Compliance.begin(), this->Compliance.end(), [](float c) { return c > 0.0F; }))
  {
    this->separate(mesh, arrays);
  }
  else
  {
    this->Compliance.clear();
  }
  this->compareCurves();
}

void BodyRelaxation::separate(const PackedMesh& mesh, const ResponseArrays& arrays)
{
  const auto samples = static_cast<std::size_t>(arrays.samples);
  const ResponseField whole(arrays);
  const ResponseSampling& sampling = whole.sampling();
  std::vector<float> force(samples * arrays.points);
  std::vector<float> stiffness(samples * arrays.points);
  std::vector<float> range(arrays.points);
  forRanges(arrays.points,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        if (!whole.isValid(point))
        {
          continue;
        }
        const auto compliance = static_cast<double>(arrays.relaxation.elasticCompliance[i]);
        const double end = whole.range(point);
        // At least a thousandth of the range is used, because a body that only bends as a whole has
        // no local part.
        const double local =
          std::max(end - compliance * whole.evaluate(point, end).force, 1e-3 * end);
        range[i] = static_cast<float>(local);
        for (std::size_t k = 0; k < samples; ++k)
        {
          const double depth = wholeDepth(whole, point, compliance,
            sampling.depth(static_cast<int>(k), static_cast<double>(range[i])));
          const ResponseValue value = whole.evaluate(point, depth);
          const double left = std::max(1.0 - compliance * value.stiffness, 1e-6);
          force[samples * i + k] = static_cast<float>(value.force);
          stiffness[samples * i + k] = static_cast<float>(value.stiffness / left);
        }
      }
    });
  ResponseArrays local = arrays;
  local.laws = 0;
  local.basis = nullptr;
  local.coefficient = nullptr;
  local.force = force.data();
  local.stiffness = stiffness.data();
  local.range = range.data();
  this->Local = std::make_unique<const ResponseField>(local, &mesh);
  this->Range = local.longestRange();
}

void BodyRelaxation::compareCurves()
{
  const ResponseField& curves = this->curves();
  const auto count = static_cast<std::int32_t>(curves.pointCount());
  std::int32_t first = 0;
  while (first < count && !curves.isValid(first))
  {
    ++first;
  }
  if (first == count)
  {
    return;
  }
  std::atomic<bool> areConvex{ isConvex(curves, first) };
  std::atomic<bool> areSame{ true };
  forRanges(curves.pointCount(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        if (curves.isValid(point) && !curves.haveSameCurve(first, point))
        {
          areSame = false;
          areConvex = areConvex && isConvex(curves, point);
        }
      }
    });
  this->AreConvex = areConvex;
  this->Same = areSame ? first : -1;
}

double BodyRelaxation::strongest() const noexcept
{
  if (!this->isPerPoint())
  {
    return this->Series.total();
  }
  double strongest = 0.0;
  const std::size_t branches = this->Series.count;
  for (std::size_t i = 0; i < this->Strength.size(); i += branches)
  {
    double sum = 0.0;
    for (std::size_t k = 0; k < branches; ++k)
    {
      sum += static_cast<double>(this->Strength[i + k]);
    }
    strongest = std::max(strongest, sum);
  }
  return strongest;
}

RelaxationStep::Branches BodyRelaxation::strength(std::int32_t point) const noexcept
{
  if (!this->isPerPoint())
  {
    return this->Series.strength;
  }
  RelaxationStep::Branches strengths{};
  const float* own = this->Strength.data() + this->Series.count * static_cast<std::size_t>(point);
  std::copy_n(own, this->Series.count, strengths.begin());
  return strengths;
}

RelaxationStep::Branches BodyRelaxation::strength(
  const TriangleCorners& points, const Vector3& weights) const noexcept
{
  if (!this->isPerPoint())
  {
    return this->Series.strength;
  }
  RelaxationStep::Branches sum{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    const RelaxationStep::Branches own = this->strength(points[k]);
    for (std::size_t i = 0; i < this->Series.count; ++i)
    {
      sum[i] += weights[static_cast<Eigen::Index>(k)] * own[i];
    }
  }
  return sum;
}

double BodyRelaxation::elasticCompliance(
  const TriangleCorners& points, const Vector3& weights) const noexcept
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 3 && !this->Compliance.empty(); ++k)
  {
    sum += weights[static_cast<Eigen::Index>(k)] *
      static_cast<double>(this->Compliance[static_cast<std::size_t>(points[k])]);
  }
  return sum;
}
} // namespace palpate
