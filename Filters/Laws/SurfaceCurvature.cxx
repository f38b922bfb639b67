// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/SurfaceCurvature.h"

#include "Contact/ParallelRanges.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Row = std::array<double, 12>;

// Factors that bound 95 of 100 errors that are estimated from a few neighbours; see
// SurfaceCurvatureTest.cxx.
constexpr double RoughOfOne = 2.5; // for the form of one point
// For an average, times 1/(1 + steps): errors of neighbours are opposite.
constexpr double RoughOfAverage = 1.3;
// For the spread: the centre of an average is not exactly the point.
constexpr double OfSpread = 0.1;
constexpr double OfCurvature = 0.02; // for facets and for the turning of forms
// Variance of the area over which a contact averages, along each axis, in contact radii².
constexpr double FeltVariance = 0.1;

/// Triangles around each point, in ascending order.
class TrianglesOfPoints
{
public:
  TrianglesOfPoints(const TriangleSpans& surface)
    : Begin(surface.pointCount + 1, 0)
    , Corner(3 * surface.triangleCount)
  {
    for (std::size_t i = 0; i < this->Corner.size(); ++i)
    {
      ++this->Begin[static_cast<std::size_t>(surface.triangles[i]) + 1];
    }
    for (std::size_t i = 0; i < surface.pointCount; ++i)
    {
      this->Begin[i + 1] += this->Begin[i];
    }
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    for (std::size_t i = 0; i < this->Corner.size(); ++i)
    {
      this->Corner[next[static_cast<std::size_t>(surface.triangles[i])]++] = i;
    }
  }

  template <class Visit>
  void forCornersOf(std::size_t point, const Visit& visit) const
  {
    for (std::size_t i = this->Begin[point]; i < this->Begin[point + 1]; ++i)
    {
      visit(this->Corner[i]);
    }
  }

private:
  std::vector<std::size_t> Begin;
  std::vector<std::size_t> Corner; ///< index in the list of corners
};

struct TangentFrame
{
  Vector3d first;
  Vector3d second;

  explicit TangentFrame(const Vector3d& normal)
    : first(normal.unitOrthogonal())
    , second(normal.cross(this->first))
  {
  }
};

/// Adds an edge to the sums of the least squares of one point: the products of (t², 2tu, u²) of the
/// direction with themselves (6) and with the curvature (3), the squared curvature, and 1. Each is
/// multiplied by the edge's length².
void addEdge(const TangentFrame& frame, const Vector3d& edge, const Vector3d& turn, Row& sums)
{
  const double t = edge.dot(frame.first);
  const double u = edge.dot(frame.second);
  const double flat = t * t + u * u;
  const double curvature = edge.dot(turn) / edge.squaredNorm();
  if (!(flat > 0.0) || !std::isfinite(curvature))
  {
    return;
  }
  const double weight = edge.squaredNorm(); // the error of a normal matters more on a short edge
  const std::array<double, 3> row = { t * t / flat, 2.0 * t * u / flat, u * u / flat };
  std::size_t place = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = i; j < 3; ++j)
    {
      sums[place++] += weight * row[i] * row[j];
    }
    sums[6 + i] += weight * row[i] * curvature;
  }
  sums[9] += weight * curvature * curvature;
  sums[10] += weight;
}

/// The second fundamental form in a tangent frame, (t², tu, u²), and the error of one fit.
struct Fit
{
  Vector3d form = Vector3d::Zero();
  double error = 0.0;
};

Fit solve(const Row& sums)
{
  if (sums[10] == 0.0)
  {
    return {};
  }
  Matrix3d products;
  products << sums[0], sums[1], sums[2], sums[1], sums[3], sums[4], sums[2], sums[4], sums[5];
  const Vector3d right(sums[6], sums[7], sums[8]);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> spread(products, Eigen::EigenvaluesOnly);
  constexpr double LeastSpread = 1e-3; // relative to the sum of weights: three distinct directions
  if (!(spread.eigenvalues()[0] > LeastSpread * sums[10]))
  {
    // t² + u² = 1, so the sum of the first and last product is the sum of the curvatures.
    const double mean = (sums[6] + sums[8]) / sums[10];
    return { { mean, 0.0, mean }, 2.0 * std::sqrt(sums[9] / sums[10]) };
  }
  const Vector3d form = products.ldlt().solve(right);
  const double left = std::max(0.0, sums[9] - form.dot(right)) / sums[10];
  return { form, std::sqrt(left) };
}

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
    , Around(surface)
  {
  }

  /// The fits of all points, and their forms in space.
  std::vector<Fit> fits(std::vector<Form>& forms) const
  {
    std::vector<Fit> found(this->Surface.pointCount);
    this->forPoints([&](std::size_t point) { return this->sumsOf(point); },
      [&](std::size_t point, const Row& sums) { found[point] = solve(sums); });
    forms.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const Vector3d normal = this->normalOf(i);
      if (!(normal.squaredNorm() > 0.0))
      {
        continue;
      }
      const TangentFrame frame(normal);
      const Vector3d& form = found[i].form;
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
      [&](std::size_t point, const Row& sums)
      {
        next[point] = forms[point];
        for (std::size_t k = 0; k < Count; ++k)
        {
          next[point][k] = (forms[point][k] + sums[k]) / (1.0 + sums[Count]);
        }
      });
    forms.swap(next);
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
      [&](std::size_t point, const Row& sums)
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

  template <class Visit>
  void forNeighbours(std::size_t point, const Visit& visit) const
  {
    this->Around.forCornersOf(point,
      [&](std::size_t corner)
      {
        for (std::size_t step = 1; step < 3; ++step)
        {
          visit(static_cast<std::size_t>(
            this->Surface.triangles[corner - corner % 3 + (corner % 3 + step) % 3]));
        }
      });
  }

  Row sumsOf(std::size_t point) const
  {
    Row sums{};
    const Vector3d normal = this->normalOf(point);
    if (!(normal.squaredNorm() > 0.0))
    {
      return sums;
    }
    const TangentFrame frame(normal);
    const Vector3d here = this->placeOf(point);
    this->forNeighbours(point,
      [&](std::size_t other)
      { addEdge(frame, this->placeOf(other) - here, this->normalOf(other) - normal, sums); });
    return sums;
  }

  Row neighboursOf(std::size_t point, const std::vector<Form>& forms) const
  {
    Row sums{};
    const Vector3d normal = this->normalOf(point);
    this->forNeighbours(point,
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
  TrianglesOfPoints Around;
};
} // namespace

int SurfaceCurvature::stepsFor(double contactRadius, double spacing)
{
  // A step adds a variance of 0.5 spacings² along each axis.
  const double ratio = contactRadius / spacing;
  return std::isfinite(ratio)
    ? static_cast<int>(std::lround(std::min(FeltVariance / 0.5 * ratio * ratio, 1.0 * MostSteps)))
    : 0;
}

SurfaceCurvature::SurfaceCurvature(const TriangleSpans& surface, const float* normals, int steps)
  : Found(surface.pointCount)
{
  const FormAverage average(surface, normals);
  std::vector<Form> forms;
  const std::vector<Fit> fits = average.fits(forms);
  const auto roughness = [&forms](std::size_t i) { return std::sqrt(forms[i][Rough]); };
  std::vector<float> halfway(forms.size());
  if (steps == 0)
  {
    average.step(forms); // needed for the roughness only
    for (std::size_t i = 0; i < forms.size(); ++i)
    {
      this->Found[i] = principal(fits[i].form, std::max(fits[i].error, RoughOfOne * roughness(i)));
    }
    return;
  }
  for (int step = 0; step < steps; ++step)
  {
    for (std::size_t i = 0; step == steps / 2 && i < forms.size(); ++i)
    {
      halfway[i] = static_cast<float>(meanOf(forms[i]));
    }
    average.step(forms);
  }
  for (std::size_t i = 0; i < forms.size(); ++i)
  {
    const Vector3d normal = average.normalOf(i);
    if (!(normal.squaredNorm() > 0.0))
    {
      continue;
    }
    const Matrix3d matrix = matrixOf(forms[i]);
    const TangentFrame frame(normal);
    const double mean = meanOf(forms[i]);
    const double change = std::abs(mean - static_cast<double>(halfway[i]));
    const double spread = std::sqrt(std::max(0.0, forms[i][Square] - mean * mean));
    this->Found[i] =
      principal({ frame.first.dot(matrix * frame.first), frame.first.dot(matrix * frame.second),
                  frame.second.dot(matrix * frame.second) },
        RoughOfAverage * roughness(i) / (1.0 + steps) + change + OfSpread * spread +
          OfCurvature * matrix.norm());
  }
}
} // namespace palpate
