// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/SurfaceForms.h"

#include "Contact/ParallelRanges.h"
#include "Laws/DiscForm.h"
#include "Laws/PointCurvature.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

// With these factors the results bound 95 of 100 errors; see SurfaceCurvatureTest.cxx.
constexpr double DiscFactor = 2.0;      // on the residual of a disc
constexpr double DiscNoiseFactor = 3.0; // additional factor if the surface is noisy
constexpr double DiscCurvatureFactor = 0.003;
constexpr double LargestDiscNoise = 0.5; // with more noise an average is more accurate than a disc
// If the ratio of the contact radius to the distance of points is between these limits, the form
// fitted to the disc is used.
constexpr double SmallestDiscRatio = 1.1;
constexpr double LargestDiscRatio = 8.0;
// Factor for an average, multiplied by 1/(1 + steps), because the errors at neighbouring points
// have opposite signs.
constexpr double AverageFactor = 1.3;
// Factor on the spread, because the centre of an average is not exactly at the point.
constexpr double SpreadFactor = 0.1;
// Factor on the curvature, for the error due to facets and to the rotation of forms.
constexpr double CurvatureFactor = 0.02;

// Limits for the correlation between the difference of the curvatures by sags and by turns at a
// point and at its neighbours. Above the first limit a surface counts as smooth, below the second
// as noisy. White noise has a correlation of -0.29.
constexpr double SmoothCorrelation = -0.12;
constexpr double NoisyCorrelation = -0.25;
// Multiple of the median; larger differences occur at edges.
constexpr double LargestDifference = 3.0;

using Curvature = PointCurvature;

/// Calls body(i, point) for all given points, in several threads.
template <class Body>
void forPoints(const std::vector<std::size_t>& points, const Body& body)
{
  forRanges(points.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        body(i, points[i]);
      }
    });
}

std::vector<std::size_t> firstNumbers(std::size_t count)
{
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  return all;
}
} // namespace

SurfaceForms::SurfaceForms(const TriangleSpans& surface, const float* normals)
  : Surface(surface)
  , Normals(normals)
  , Rings(surface)
  , Fits(surface.pointCount)
  , Forms(surface.pointCount, SpaceForm{})
  , Spacing(pointSpacing(surface))
{
  this->fitPoints();
  this->findRoughness();
  this->findNoise();
}

/// Computes the fits at all points, and the corresponding forms in space.
void SurfaceForms::fitPoints()
{
  forRanges(this->Fits.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        this->Fits[i] = this->sumsOf(i).fit();
        const Vector3d normal = this->normalOf(i);
        if (!(normal.squaredNorm() > 0.0))
        {
          continue;
        }
        this->Forms[i] = SpaceForm(this->Fits[i].byTurns, TangentFrame(normal));
      }
    });
}

/// Computes the difference between each mean curvature and the mean over the neighbours. This
/// difference contains noise and detail that is too fine for the mesh, but no gradient of the
/// curvature.
void SurfaceForms::findRoughness()
{
  std::vector<double> rough(this->Forms.size(), 0.0);
  forRanges(this->Forms.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const SpaceForm sums = this->neighboursOf(i, this->Forms);
        if (sums.of[SpaceForm::Count] > 0.0)
        {
          rough[i] = this->Forms[i].mean() -
            0.5 * (sums.of[0] + sums.of[3] + sums.of[5]) / sums.of[SpaceForm::Count];
        }
      }
    });
  for (std::size_t i = 0; i < rough.size(); ++i)
  {
    this->Forms[i].of[SpaceForm::Rough] = rough[i] * rough[i];
  }
}

/// Computes the fraction of noise. Noise moves neighbouring points in opposite directions.
void SurfaceForms::findNoise()
{
  std::vector<double> differences;
  differences.reserve(this->Fits.size());
  for (const PointForm& fit : this->Fits)
  {
    differences.push_back(std::abs(fit.difference()));
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  const double most = middle == differences.end() ? 0.0 : LargestDifference * *middle;
  const auto clipped = [&](std::size_t i)
  { return std::clamp(this->Fits[i].difference(), -most, most); };
  forRanges(this->Fits.size(),
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        double sum = 0.0;
        double count = 0.0;
        this->Rings.forCorners(i,
          [&](std::size_t other, std::size_t)
          {
            sum += clipped(other);
            count += 1.0;
          });
        differences[i] = count > 0.0 ? sum / count : 0.0;
      }
    });
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < this->Fits.size(); ++i)
  {
    products += clipped(i) * differences[i];
    squares += clipped(i) * clipped(i);
  }
  this->Noise = squares > 0.0
    ? std::clamp(
        (SmoothCorrelation - products / squares) / (SmoothCorrelation - NoisyCorrelation), 0.0, 1.0)
    : 0.0;
}

std::vector<Curvature> SurfaceForms::curvatures(double contactRadius) const
{
  std::vector<Curvature> found(this->Fits.size(), Curvature{});
  const double ratio = contactRadius / this->Spacing;
  const bool hasDiscs =
    ratio > SmallestDiscRatio && ratio < LargestDiscRatio && this->Noise < LargestDiscNoise;
  const std::vector<std::size_t> others =
    hasDiscs ? this->takeDiscs(contactRadius, found) : firstNumbers(found.size());
  if (others.empty())
  {
    return found;
  }
  const double steps = std::isfinite(ratio)
    ? std::min((ContactVariance * ratio * ratio - TurnVariance) / StepVariance, 1.0 * MostSteps)
    : 0.0;
  if (steps > 0.0)
  {
    this->takeAverages(steps, others, found);
    return found;
  }
  std::vector<SpaceForm> forms = this->Forms;
  this->step(others, forms); // needed only for the roughness
  for (const std::size_t i : others)
  {
    found[i] = pointCurvature(
      this->Fits[i], std::sqrt(forms[i].of[SpaceForm::Rough]), contactRadius, this->Noise);
  }
  return found;
}

/// Sets the curvatures of each point from the form fitted to the disc under the contact. Returns
/// the points whose discs do not have enough points.
std::vector<std::size_t> SurfaceForms::takeDiscs(
  double contactRadius, std::vector<Curvature>& found) const
{
  const double factor = DiscFactor * (1.0 + DiscNoiseFactor * this->Noise);
  std::vector<unsigned char> hasDisc(found.size(), 0);
  const std::vector<NormalPoint> points = normalPoints(this->Surface, this->Normals);
  forRanges(found.size(),
    [&](std::size_t first, std::size_t last)
    {
      DiscForms discs(points, this->Rings, this->Spacing, contactRadius);
      for (std::size_t i = first; i < last; ++i)
      {
        if (const std::optional<DiscForm> disc = discs.fit(i))
        {
          found[i] = principal(
            disc->form, factor * disc->residual + DiscCurvatureFactor * disc->form.norm());
          hasDisc[i] = 1;
        }
      }
    });
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (hasDisc[i] == 0)
    {
      others.push_back(i);
    }
  }
  return others;
}

/// Sets the curvatures of `points` to the values after `steps` averaging steps. The last step may
/// be partial.
void SurfaceForms::takeAverages(
  double steps, const std::vector<std::size_t>& points, std::vector<Curvature>& found) const
{
  const int whole = static_cast<int>(std::ceil(steps));
  // The points needed in a step are the points of the next step and their neighbours.
  std::vector<std::vector<std::size_t>> reached{ points };
  while (static_cast<int>(reached.size()) < whole)
  {
    reached.push_back(this->withNeighbours(reached.back()));
  }
  std::vector<SpaceForm> forms = this->Forms;
  std::vector<SpaceForm> before;
  std::vector<float> halfway(points.size());
  for (int step = 0; step < whole; ++step)
  {
    for (std::size_t i = 0; step == whole / 2 && i < points.size(); ++i)
    {
      halfway[i] = static_cast<float>(forms[points[i]].mean());
    }
    if (step == whole - 1)
    {
      before = forms;
    }
    this->step(reached[static_cast<std::size_t>(whole - 1 - step)], forms);
  }
  const double last = steps - (whole - 1);
  forPoints(points,
    [&](std::size_t i, std::size_t point)
    {
      const Vector3d normal = this->normalOf(point);
      if (!(normal.squaredNorm() > 0.0))
      {
        return;
      }
      SpaceForm form = forms[point];
      for (std::size_t k = 0; k < SpaceForm::Count; ++k)
      {
        form.of[k] = (1.0 - last) * before[point].of[k] + last * form.of[k];
      }
      const Matrix3d matrix = form.matrix();
      const TangentFrame frame(normal);
      const double mean = form.mean();
      const double change = std::abs(mean - static_cast<double>(halfway[i]));
      const double spread = std::sqrt(std::max(0.0, form.of[SpaceForm::Square] - mean * mean));
      found[point] =
        principal({ frame.first.dot(matrix * frame.first), frame.first.dot(matrix * frame.second),
                    frame.second.dot(matrix * frame.second) },
          AverageFactor * std::sqrt(form.of[SpaceForm::Rough]) / (1.0 + steps) + change +
            SpreadFactor * spread + CurvatureFactor * matrix.norm());
    });
}

/// Replaces the form at each of `points` (ascending) by the mean over the point and its neighbours.
void SurfaceForms::step(const std::vector<std::size_t>& points, std::vector<SpaceForm>& forms) const
{
  std::vector<SpaceForm> next(points.size());
  forPoints(points,
    [&](std::size_t i, std::size_t point)
    {
      const SpaceForm sums = this->neighboursOf(point, forms);
      next[i] = forms[point];
      for (std::size_t k = 0; k < SpaceForm::Count; ++k)
      {
        next[i].of[k] = (forms[point].of[k] + sums.of[k]) / (1.0 + sums.of[SpaceForm::Count]);
      }
    });
  if (points.size() == forms.size())
  {
    forms.swap(next);
    return;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    forms[points[i]] = next[i];
  }
}

std::vector<std::size_t> SurfaceForms::withNeighbours(const std::vector<std::size_t>& points) const
{
  if (points.size() == this->Forms.size())
  {
    return points;
  }
  std::vector<bool> isIn(this->Forms.size(), false);
  for (const std::size_t point : points)
  {
    isIn[point] = true;
    this->Rings.forEachNeighbour(point, [&](std::size_t other) { isIn[other] = true; });
  }
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < isIn.size(); ++i)
  {
    if (isIn[i])
    {
      all.push_back(i);
    }
  }
  return all;
}

Vector3d SurfaceForms::normalOf(std::size_t point) const
{
  return Eigen::Map<const Eigen::Vector3f>(this->Normals + 3 * point).cast<double>();
}

Vector3d SurfaceForms::placeOf(std::size_t point) const
{
  return Eigen::Map<const Vector3d>(this->Surface.points + 3 * point);
}

PointFormSums SurfaceForms::sumsOf(std::size_t point) const
{
  const Vector3d normal = this->normalOf(point);
  PointFormSums sums(normal);
  if (normal.squaredNorm() > 0.0)
  {
    const Vector3d here = this->placeOf(point);
    this->Rings.forCorners(point,
      [&](std::size_t other, std::size_t)
      { sums.add(this->placeOf(other) - here, this->normalOf(other) - normal); });
  }
  return sums;
}

/// Returns the sums of the forms at the corners around a point, rotated to the normal of the point.
SpaceForm SurfaceForms::neighboursOf(std::size_t point, const std::vector<SpaceForm>& forms) const
{
  static thread_local std::vector<SpaceForm> turned; // reused for all points of a thread
  turned.clear();
  const Vector3d normal = this->normalOf(point);
  this->Rings.forEachNeighbour(point,
    [&](std::size_t other)
    {
      turned.push_back(forms[other]);
      SpaceForm& form = turned.back();
      const Vector3d from = this->normalOf(other);
      constexpr double LeastCosine = -0.5; // smaller cosines occur beyond a sharp edge
      if (form.of[SpaceForm::Count] == 0.0 || !(from.dot(normal) > LeastCosine))
      {
        form.of[SpaceForm::Count] = 0.0;
        return;
      }
      form.turn(from, normal);
    });
  SpaceForm sums{};
  this->Rings.forCorners(point,
    [&](std::size_t, std::size_t place)
    {
      const SpaceForm& form = turned[place];
      for (std::size_t k = 0; form.of[SpaceForm::Count] > 0.0 && k <= SpaceForm::Count; ++k)
      {
        sums.of[k] += form.of[k];
      }
    });
  return sums;
}
} // namespace palpate
