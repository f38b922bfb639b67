// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/SurfaceCurvature.h"

#include "Contact/ParallelRanges.h"
#include "Laws/DiscForm.h"
#include "Laws/PointForm.h"
#include "Laws/PointRings.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Factors that bound 95 of 100 errors that are estimated from a few neighbours; see
// SurfaceCurvatureTest.cxx.
constexpr double PointFactor =
  0.7; // for the form of one point: of roughness, residual and difference
constexpr double NoisyPointFactor = 2.5; // with noise
constexpr double DiscFactor = 2.0;       // of the residual of a disc
constexpr double DiscNoiseFactor = 3.0;  // more with noise
constexpr double DiscCurvatureFactor = 0.003;
constexpr double LargestDiscNoise = 0.5; // with more noise an average is better
// A contact of a radius between these, in distances of points, gets the form of its disc.
constexpr double SmallestDiscRatio = 1.1;
constexpr double LargestDiscRatio = 8.0;
// For an average, times 1/(1 + steps): errors of neighbours are opposite.
constexpr double AverageFactor = 1.3;
// For the spread: the centre of an average is not exactly the point.
constexpr double SpreadFactor = 0.1;
constexpr double CurvatureFactor = 0.02; // for facets and for the turning of forms

// Variances of averages along each axis. ContactVariance is that of the area over which a contact
// averages, in contact radii²; the others are in squared distances of points. For a wave of the
// wavenumber k on a triangular lattice with edges e, the curvature by sags is too small by
// (k e)²/12, and that by turns by (k e)²/4.
constexpr double ContactVariance = 0.1;
constexpr double SagVariance = 0.192;
constexpr double TurnVariance = 0.577;
constexpr double StepVariance = 0.5;
constexpr double EdgeSquare = 1.155; // of the lattice, in squared distances of points
/// The largest weight of the sags, for contacts smaller than the facets.
constexpr double LargestSagWeight = 1.5;
// The correlation of the difference between sags and turns with that of the neighbours: between
// these values a surface counts as smooth and as noisy. That of white noise is -0.29.
constexpr double SmoothCorrelation = -0.12;
constexpr double NoisyCorrelation = -0.25;
constexpr double LargestDifference = 3.0; // times the median: larger ones are those of edges

std::array<float, 3> principal(const Vector3d& form, double error)
{
  const double mean = 0.5 * (form[0] + form[2]);
  const double half = std::hypot(0.5 * (form[0] - form[2]), form[1]);
  return { static_cast<float>(mean - half), static_cast<float>(mean + half),
    static_cast<float>(error) };
}

/// A form in space (xx, xy, xz, yy, yz, zz), the square of its mean curvature, the square of its
/// roughness (findRoughness), and a count.
using Form = std::array<double, 9>;
constexpr std::size_t Square = 6;
constexpr std::size_t Rough = 7;
constexpr std::size_t Count = 8;

Matrix3d matrixOf(const Form& form)
{
  Matrix3d matrix;
  matrix << form[0], form[1], form[2], form[1], form[3], form[4], form[2], form[4], form[5];
  return matrix;
}

double meanOf(const Form& form)
{
  return 0.5 * (form[0] + form[3] + form[5]);
}

void setMatrix(const Matrix3d& matrix, Form& form)
{
  form = { matrix(0, 0), matrix(0, 1), matrix(0, 2), matrix(1, 1), matrix(1, 2), matrix(2, 2),
    form[Square], form[Rough], form[Count] };
}

/// Turns a form by the smallest rotation from one normal to another.
void turn(const Vector3d& from, const Vector3d& to, Form& form)
{
  const Vector3d axis = from.cross(to);
  const double cosine = from.dot(to);
  Matrix3d cross;
  cross << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
  const Matrix3d rotation = Matrix3d::Identity() + cross + cross * cross / (1.0 + cosine);
  setMatrix(rotation * matrixOf(form) * rotation.transpose(), form);
}

class FormAverage
{
public:
  FormAverage(const TriangleSpans& surface, const float* normals)
    : Surface(surface)
    , Normals(normals)
    , Rings(surface)
  {
  }

  /// The fits of all points, and their forms in space.
  std::vector<PointForm> fits(std::vector<Form>& forms) const
  {
    std::vector<PointForm> found(this->Surface.pointCount);
    this->forPoints([&](std::size_t point) { return this->sumsOf(point); },
      [&](std::size_t point, const PointFormSums& sums) { found[point] = sums.fit(); });
    forms.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const Vector3d normal = this->normalOf(i);
      if (!(normal.squaredNorm() > 0.0))
      {
        continue;
      }
      const TangentFrame frame(normal);
      const Vector3d& form = found[i].byTurns;
      setMatrix(form[0] * frame.first * frame.first.transpose() +
          form[2] * frame.second * frame.second.transpose() +
          form[1] *
            (frame.first * frame.second.transpose() + frame.second * frame.first.transpose()),
        forms[i]);
      forms[i][Square] = meanOf(forms[i]) * meanOf(forms[i]);
      forms[i][Count] = 1.0;
    }
    this->findRoughness(forms);
    return found;
  }

  /// Replaces each form by the mean of itself and its neighbours.
  void step(std::vector<Form>& forms) const
  {
    std::vector<Form> next(forms.size());
    this->forPoints([&](std::size_t point) { return this->neighboursOf(point, forms); },
      [&](std::size_t point, const Form& sums)
      {
        next[point] = forms[point];
        for (std::size_t k = 0; k < Count; ++k)
        {
          next[point][k] = (forms[point][k] + sums[k]) / (1.0 + sums[Count]);
        }
      });
    forms.swap(next);
  }

  /// The fraction of noise in the points: noise moves neighbours against each other.
  double noise(const std::vector<PointForm>& fits) const
  {
    std::vector<double> differences;
    for (const PointForm& fit : fits)
    {
      differences.push_back(std::abs(fit.difference()));
    }
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    const double most = middle == differences.end() ? 0.0 : LargestDifference * *middle;
    const auto clipped = [&](std::size_t i)
    { return std::clamp(fits[i].difference(), -most, most); };
    double products = 0.0;
    double squares = 0.0;
    this->forPoints(
      [&](std::size_t point)
      {
        std::array<double, 2> sums{};
        this->Rings.forNeighbours(point,
          [&](std::size_t other)
          {
            sums[0] += clipped(other);
            sums[1] += 1.0;
          });
        return sums;
      },
      [&](std::size_t point, const std::array<double, 2>& sums)
      { differences[point] = sums[1] > 0.0 ? sums[0] / sums[1] : 0.0; });
    for (std::size_t i = 0; i < fits.size(); ++i)
    {
      products += clipped(i) * differences[i];
      squares += clipped(i) * clipped(i);
    }
    return squares > 0.0 ? std::clamp((SmoothCorrelation - products / squares) /
                               (SmoothCorrelation - NoisyCorrelation),
                             0.0, 1.0)
                         : 0.0;
  }

  /// The curvatures after so many steps, the last one in part.
  std::vector<std::array<float, 3>> averaged(double steps, std::vector<Form>& forms) const
  {
    std::vector<std::array<float, 3>> found(forms.size());
    const int whole = static_cast<int>(std::ceil(steps));
    std::vector<Form> before;
    std::vector<float> halfway(forms.size());
    for (int step = 0; step < whole; ++step)
    {
      for (std::size_t i = 0; step == whole / 2 && i < forms.size(); ++i)
      {
        halfway[i] = static_cast<float>(meanOf(forms[i]));
      }
      before = forms;
      this->step(forms);
    }
    const double last = steps - (whole - 1);
    for (std::size_t i = 0; i < forms.size(); ++i)
    {
      const Vector3d normal = this->normalOf(i);
      if (!(normal.squaredNorm() > 0.0))
      {
        continue;
      }
      for (std::size_t k = 0; k < Count; ++k)
      {
        forms[i][k] = (1.0 - last) * before[i][k] + last * forms[i][k];
      }
      const Matrix3d matrix = matrixOf(forms[i]);
      const TangentFrame frame(normal);
      const double mean = meanOf(forms[i]);
      const double change = std::abs(mean - static_cast<double>(halfway[i]));
      const double spread = std::sqrt(std::max(0.0, forms[i][Square] - mean * mean));
      found[i] =
        principal({ frame.first.dot(matrix * frame.first), frame.first.dot(matrix * frame.second),
                    frame.second.dot(matrix * frame.second) },
          AverageFactor * std::sqrt(forms[i][Rough]) / (1.0 + steps) + change +
            SpreadFactor * spread + CurvatureFactor * matrix.norm());
    }
    return found;
  }

  /// Replaces the curvatures by those of the forms fitted to the disc under the contact, where the
  /// disc has enough points.
  void takeDiscs(double spacing, double contactRadius, double noise,
    std::vector<std::array<float, 3>>& found) const
  {
    const double factor = DiscFactor * (1.0 + DiscNoiseFactor * noise);
    forRanges(this->Surface.pointCount,
      [&](std::size_t first, std::size_t last)
      {
        DiscForms discs(this->Surface, this->Normals, this->Rings, spacing, contactRadius);
        for (std::size_t i = first; i < last; ++i)
        {
          if (const std::optional<DiscForm> disc = discs.fit(i))
          {
            found[i] = principal(
              disc->form, factor * disc->residual + DiscCurvatureFactor * disc->form.norm());
          }
        }
      });
  }

  Vector3d normalOf(std::size_t point) const
  {
    return Eigen::Map<const Eigen::Vector3f>(this->Normals + 3 * point).cast<double>();
  }

private:
  /// The difference of each mean curvature from the mean of its neighbours. It contains noise and
  /// detail too fine for the mesh, but no gradient of the curvature.
  void findRoughness(std::vector<Form>& forms) const
  {
    std::vector<double> rough(forms.size(), 0.0);
    this->forPoints([&](std::size_t point) { return this->neighboursOf(point, forms); },
      [&](std::size_t point, const Form& sums)
      {
        if (sums[Count] > 0.0)
        {
          rough[point] = meanOf(forms[point]) - 0.5 * (sums[0] + sums[3] + sums[5]) / sums[Count];
        }
      });
    for (std::size_t i = 0; i < forms.size(); ++i)
    {
      forms[i][Rough] = rough[i] * rough[i];
    }
  }

  /// Calls `take(point, gather(point))` for each point.
  template <class Gather, class Take>
  void forPoints(const Gather& gather, const Take& take) const
  {
    forRanges(this->Surface.pointCount,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          take(i, gather(i));
        }
      });
  }

  Vector3d placeOf(std::size_t point) const
  {
    return Eigen::Map<const Vector3d>(this->Surface.points + 3 * point);
  }

  PointFormSums sumsOf(std::size_t point) const
  {
    const Vector3d normal = this->normalOf(point);
    PointFormSums sums(normal);
    if (normal.squaredNorm() > 0.0)
    {
      const Vector3d here = this->placeOf(point);
      this->Rings.forNeighbours(point,
        [&](std::size_t other)
        { sums.add(this->placeOf(other) - here, this->normalOf(other) - normal); });
    }
    return sums;
  }

  Form neighboursOf(std::size_t point, const std::vector<Form>& forms) const
  {
    Form sums{};
    const Vector3d normal = this->normalOf(point);
    this->Rings.forNeighbours(point,
      [&](std::size_t other)
      {
        Form form = forms[other];
        const Vector3d from = this->normalOf(other);
        constexpr double LeastCosine = -0.5; // beyond a sharp edge
        if (form[Count] == 0.0 || !(from.dot(normal) > LeastCosine))
        {
          return;
        }
        turn(from, normal, form);
        for (std::size_t k = 0; k <= Count; ++k)
        {
          sums[k] += form[k];
        }
      });
    return sums;
  }

  const TriangleSpans& Surface;
  const float* Normals;
  PointRings Rings;
};

/// The curvature of a contact that is not wider than the turns average, on a surface with such a
/// fraction of noise.
std::array<float, 3> pointCurvature(
  const PointForm& fit, double roughness, double contactRadius, double noise)
{
  const double wanted = fit.edgeSquare > 0.0
    ? ContactVariance * contactRadius * contactRadius * EdgeSquare / fit.edgeSquare
    : 0.0;
  const double finer = (1.0 - noise) *
    std::clamp((TurnVariance - wanted) / (TurnVariance - SagVariance), 0.0, LargestSagWeight);
  const double smooth =
    PointFactor * Eigen::Vector3d(roughness, fit.residual, (1.0 - noise) * fit.difference()).norm();
  const double noisy = std::max(fit.residual, NoisyPointFactor * roughness);
  return principal(
    fit.byTurns + finer * (fit.bySags - fit.byTurns), noise * noisy + (1.0 - noise) * smooth);
}
} // namespace

SurfaceCurvature::SurfaceCurvature(
  const TriangleSpans& surface, const float* normals, double contactRadius)
  : Found(surface.pointCount)
{
  const FormAverage average(surface, normals);
  std::vector<Form> forms;
  const std::vector<PointForm> fits = average.fits(forms);
  const double noise = average.noise(fits);
  const double spacing = pointSpacing(surface);
  const double ratio = contactRadius / spacing;
  const double steps = std::isfinite(ratio)
    ? std::min((ContactVariance * ratio * ratio - TurnVariance) / StepVariance, 1.0 * MostSteps)
    : 0.0;
  if (steps > 0.0)
  {
    this->Found = average.averaged(steps, forms);
  }
  else
  {
    average.step(forms); // needed for the roughness only
    for (std::size_t i = 0; i < forms.size(); ++i)
    {
      this->Found[i] = pointCurvature(fits[i], std::sqrt(forms[i][Rough]), contactRadius, noise);
    }
  }
  if (ratio > SmallestDiscRatio && ratio < LargestDiscRatio && noise < LargestDiscNoise)
  {
    average.takeDiscs(spacing, contactRadius, noise, this->Found);
  }
}
} // namespace palpate
