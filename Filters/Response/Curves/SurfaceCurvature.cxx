// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/SurfaceCurvature.h"

#include "Response/Pieces/BodySeam.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>

namespace palpate
{
namespace
{
/// Sums of the least squares of one point: a, the products of (t², 2tu, u²) of the direction with
/// themselves (6) and with the curvature (3), its square and the number of edges.
using EdgeSums = std::array<double, 11>;

struct TangentFrame
{
  Eigen::Vector3d first;
  Eigen::Vector3d second;

  explicit TangentFrame(const Eigen::Vector3d& normal)
    : first(normal.unitOrthogonal())
    , second(normal.cross(this->first))
  {
  }
};

/// Triangles around each point, in rising order.
class TrianglesOfPoints
{
public:
  TrianglesOfPoints(const std::vector<vtkIdType>& corners, std::size_t points)
    : Begin(points + 1, 0)
    , Corner(corners.size())
  {
    for (const vtkIdType point : corners)
    {
      ++this->Begin[static_cast<std::size_t>(point) + 1];
    }
    for (std::size_t i = 0; i < points; ++i)
    {
      this->Begin[i + 1] += this->Begin[i];
    }
    std::vector<std::size_t> next(this->Begin.begin(), this->Begin.end() - 1);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      this->Corner[next[static_cast<std::size_t>(corners[i])]++] = i;
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
  std::vector<std::size_t> Corner; ///< place in the list of corners
};

Eigen::Vector3d normalOf(const float* normals, std::size_t point)
{
  return Eigen::Map<const Eigen::Vector3f>(normals + 3 * point).cast<double>();
}

void addEdge(const TangentFrame& frame, const Eigen::Vector3d& edge, const Eigen::Vector3d& turn,
  EdgeSums& sums)
{
  const double t = edge.dot(frame.first);
  const double u = edge.dot(frame.second);
  const double flat = t * t + u * u;
  const double curvature = edge.dot(turn) / edge.squaredNorm();
  if (!(flat > 0.0) || !std::isfinite(curvature))
  {
    return;
  }
  const std::array<double, 3> row = { t * t / flat, 2.0 * t * u / flat, u * u / flat };
  std::size_t place = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = i; j < 3; ++j)
    {
      sums[place++] += row[i] * row[j];
    }
    sums[6 + i] += row[i] * curvature;
  }
  sums[9] += curvature * curvature;
  sums[10] += 1.0;
}

std::array<float, 3> solve(const EdgeSums& sums)
{
  if (sums[10] == 0.0)
  {
    return { 0.0F, 0.0F, 0.0F };
  }
  Eigen::Matrix3d products;
  products << sums[0], sums[1], sums[2], sums[1], sums[3], sums[4], sums[2], sums[4], sums[5];
  const Eigen::Vector3d right(sums[6], sums[7], sums[8]);
  // Of the edges' number, the least eigenvalue: three directions, none beside another. It is above
  // where the products without it are still positive definite.
  constexpr double LeastSpread = 1e-3;
  const Eigen::Matrix3d least = LeastSpread * sums[10] * Eigen::Matrix3d::Identity();
  if (Eigen::LLT<Eigen::Matrix3d>(products - least).info() != Eigen::Success)
  {
    // t² + u² = 1: the curvatures sum up to the first and last product.
    const double mean = (sums[6] + sums[8]) / sums[10];
    const double largest = std::sqrt(sums[9]);
    return { static_cast<float>(mean), static_cast<float>(mean), static_cast<float>(largest) };
  }
  const Eigen::Vector3d form = products.llt().solve(right);
  const double mean = 0.5 * (form[0] + form[2]);
  const double half = std::hypot(0.5 * (form[0] - form[2]), form[1]);
  const double left = std::max(0.0, sums[9] - form.dot(right)) / sums[10];
  return { static_cast<float>(mean - half), static_cast<float>(mean + half),
    static_cast<float>(std::sqrt(left)) };
}

/// Places of points, whatever they are stored as.
template <class Number>
struct Places
{
  const Number* values;

  Eigen::Vector3d operator()(std::size_t point) const
  {
    return Eigen::Map<const Eigen::Matrix<Number, 3, 1>>(values + 3 * point)
      .template cast<double>();
  }
};

/// Calls `visit` with the places of the points; those of other types are copied.
template <class Visit>
void withPlaces(vtkPoints* points, const Visit& visit)
{
  vtkDataArray* data = points->GetData();
  if (auto* floats = vtkFloatArray::SafeDownCast(data))
  {
    visit(Places<float>{ floats->GetPointer(0) });
    return;
  }
  vtkNew<vtkDoubleArray> copy;
  auto* doubles = vtkDoubleArray::SafeDownCast(data);
  if (!doubles)
  {
    copy->DeepCopy(data);
    doubles = copy;
  }
  visit(Places<double>{ doubles->GetPointer(0) });
}
} // namespace

SurfaceCurvature::SurfaceCurvature(vtkPolyData* body, const BodySeam& seam, const float* normals)
  : Found(static_cast<std::size_t>(body->GetNumberOfPoints()))
{
  const std::size_t points = this->Found.size();
  std::vector<vtkIdType> corners;
  corners.reserve(static_cast<std::size_t>(3 * body->GetNumberOfPolys()));
  vtkCellArray* polys = body->GetPolys();
  for (vtkIdType cell = 0; polys && cell < polys->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polys->GetCellAtId(cell, size, ids);
    corners.insert(corners.end(), ids, ids + size);
  }
  const TrianglesOfPoints around(corners, points);
  std::vector<EdgeSums> own;
  const auto find = [&](const auto& placeOf)
  {
    const auto sumsOf = [&](std::size_t point)
    {
      EdgeSums sums{};
      const Eigen::Vector3d normal = normalOf(normals, point);
      if (!(normal.squaredNorm() > 0.0))
      {
        return sums;
      }
      const TangentFrame frame(normal);
      const Eigen::Vector3d here = placeOf(point);
      around.forCornersOf(point,
        [&](std::size_t corner)
        {
          const std::size_t place = corner % 3;
          for (const std::size_t next : { place == 2 ? 0 : place + 1, place == 0 ? 2 : place - 1 })
          {
            const auto other = static_cast<std::size_t>(corners[corner - place + next]);
            addEdge(frame, placeOf(other) - here, normalOf(normals, other) - normal, sums);
          }
        });
      return sums;
    };
    vtkSMPTools::For(0, static_cast<vtkIdType>(points),
      [&](vtkIdType first, vtkIdType last)
      {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
        {
          this->Found[i] = solve(sumsOf(i));
        }
      });
    for (const BodySeam::Place& place : seam.places())
    {
      own.push_back(sumsOf(static_cast<std::size_t>(place.point)));
    }
  };
  if (points > 0)
  {
    withPlaces(body->GetPoints(), find);
  }
  const std::vector<EdgeSums> whole = seam.combined(own, EdgeSums{},
    [](EdgeSums sum, const EdgeSums& part)
    {
      std::transform(sum.begin(), sum.end(), part.begin(), sum.begin(), std::plus<double>());
      return sum;
    });
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    this->Found[static_cast<std::size_t>(seam.places()[i].point)] = solve(whole[i]);
  }
}
} // namespace palpate
