// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/CurvatureBound.h"

#include "Response/Pieces/BodySeam.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
using Bounds = std::vector<std::atomic<std::int32_t>>;

static_assert(sizeof(std::int32_t) == sizeof(float), "a bound holds the bits of a float");

void raise(std::atomic<std::int32_t>& bound, float value)
{
  std::int32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  ++bits;
  std::int32_t seen = bound.load(std::memory_order_relaxed);
  while (bits > seen && !bound.compare_exchange_weak(seen, bits, std::memory_order_relaxed))
  {
  }
}

struct Triangle
{
  std::array<std::array<double, 3>, 3> corner;
  std::array<const float*, 3> normal;

  bool hasArea() const
  {
    const auto& p = this->corner;
    const double u[3] = { p[1][0] - p[0][0], p[1][1] - p[0][1], p[1][2] - p[0][2] };
    const double v[3] = { p[2][0] - p[0][0], p[2][1] - p[0][1], p[2][2] - p[0][2] };
    const double c[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    return c[0] * c[0] + c[1] * c[1] + c[2] * c[2] > 0.0; // this is also false for NaN
  }

  float curvature(std::size_t i, std::size_t j) const
  {
    double along = 0.0;
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double edge = this->corner[j][k] - this->corner[i][k];
      along +=
        edge * (static_cast<double>(this->normal[j][k]) - static_cast<double>(this->normal[i][k]));
      squared += edge * edge;
    }
    const double curvature = std::abs(along / squared);
    return curvature < 1e30 ? static_cast<float>(curvature) : 1e30F;
  }
};

struct RaiseBounds
{
  template <class CellState, class PointRange>
  void operator()(
    CellState& state, const PointRange& points, const float* normals, Bounds& bounds) const
  {
    const auto* connectivity = state.GetConnectivity();
    vtkSMPTools::For(0, state.GetNumberOfCells(),
      [&points, &bounds, normals, connectivity](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType cell = first; cell < last; ++cell)
        {
          Triangle triangle;
          std::array<vtkIdType, 3> id;
          for (std::size_t k = 0; k < 3; ++k)
          {
            id[k] =
              static_cast<vtkIdType>(connectivity->GetValue(3 * cell + static_cast<vtkIdType>(k)));
            const auto point = points[id[k]];
            triangle.corner[k] = { static_cast<double>(point[0]), static_cast<double>(point[1]),
              static_cast<double>(point[2]) };
            triangle.normal[k] = normals + 3 * id[k];
          }
          if (!triangle.hasArea())
          {
            continue;
          }
          for (std::size_t k = 0; k < 3; ++k)
          {
            const std::size_t next = (k + 1) % 3;
            const float curvature = triangle.curvature(k, next);
            raise(bounds[static_cast<std::size_t>(id[k])], curvature);
            raise(bounds[static_cast<std::size_t>(id[next])], curvature);
          }
        }
      });
  }
};

struct OverPoints
{
  template <class Array>
  void operator()(Array* points, vtkCellArray* polys, const float* normals, Bounds& bounds) const
  {
    const auto range = vtk::DataArrayTupleRange<3>(points);
    polys->Visit(RaiseBounds{}, range, normals, bounds);
  }
};
} // namespace

CurvatureBound::CurvatureBound(vtkPolyData* body, const BodySeam& seam, const float* normals)
  : Raised(static_cast<std::size_t>(body->GetNumberOfPoints()))
{
  if (!this->Raised.empty())
  {
    vtkDataArray* points = body->GetPoints()->GetData();
    using Dispatcher = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
    if (!Dispatcher::Execute(points, OverPoints{}, body->GetPolys(), normals, this->Raised))
    {
      OverPoints{}(points, body->GetPolys(), normals, this->Raised);
    }
  }
  this->joinAlong(seam);
}

void CurvatureBound::joinAlong(const BodySeam& seam)
{
  std::vector<std::int32_t> own;
  for (const BodySeam::Place& place : seam.places())
  {
    own.push_back(this->Raised[static_cast<std::size_t>(place.point)]);
  }
  const std::vector<std::int32_t> largest =
    seam.combined(own, 0, [](std::int32_t a, std::int32_t b) { return std::max(a, b); });
  for (std::size_t i = 0; i < largest.size(); ++i)
  {
    this->Raised[static_cast<std::size_t>(seam.places()[i].point)] = largest[i];
  }
}

float CurvatureBound::at(vtkIdType point) const noexcept
{
  const std::int32_t raised =
    this->Raised[static_cast<std::size_t>(point)].load(std::memory_order_relaxed);
  if (raised == 0)
  {
    return -1.0F;
  }
  const std::int32_t bits = raised - 1;
  float bound = 0.0F;
  std::memcpy(&bound, &bits, sizeof bound);
  return bound;
}
} // namespace palpate
