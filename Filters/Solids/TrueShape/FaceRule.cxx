// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/FaceRule.h"

#include "Mechanics/Numerics/GaussLegendre.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace palpate
{
namespace
{
/// Shape functions of a face, and their derivatives with respect to the two coordinates of the
/// face.
struct FaceShape
{
  Eigen::Matrix<double, 6, 1> value = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, 2> slope = Eigen::Matrix<double, 6, 2>::Zero();
};

/// Returns the coordinates of a node: the corners of [-1, 1]² or of the unit triangle, followed by
/// the mid-edge nodes of the triangle.
Eigen::Vector2d nodePlace(int count, int i)
{
  constexpr std::array<std::array<double, 2>, 4> square = { { { -1, -1 }, { 1, -1 }, { 1, 1 },
    { -1, 1 } } };
  constexpr std::array<std::array<double, 2>, 6> triangle = { { { 0, 0 }, { 1, 0 }, { 0, 1 },
    { 0.5, 0 }, { 0.5, 0.5 }, { 0, 0.5 } } };
  const auto& c =
    count == 4 ? square[static_cast<std::size_t>(i)] : triangle[static_cast<std::size_t>(i)];
  return { c[0], c[1] };
}

FaceShape shapeAt(int count, const Eigen::Vector2d& xi)
{
  FaceShape s;
  if (count == 4)
  {
    for (int i = 0; i < 4; ++i)
    {
      const Eigen::Vector2d c = nodePlace(4, i);
      const double x = 1.0 + c[0] * xi[0];
      const double y = 1.0 + c[1] * xi[1];
      s.value[i] = 0.25 * x * y;
      s.slope.row(i) << 0.25 * c[0] * y, 0.25 * x * c[1];
    }
    return s;
  }
  const Eigen::Vector3d l(1.0 - xi[0] - xi[1], xi[0], xi[1]);
  Eigen::Matrix<double, 3, 2> slope;
  slope << -1, -1, 1, 0, 0, 1;
  for (int i = 0; i < 3; ++i)
  {
    s.value[i] = count == 3 ? l[i] : l[i] * (2.0 * l[i] - 1.0);
    s.slope.row(i) = (count == 3 ? 1.0 : 4.0 * l[i] - 1.0) * slope.row(i);
  }
  for (int i = 0; i < 3 && count == 6; ++i)
  {
    const int j = (i + 1) % 3;
    s.value[3 + i] = 4.0 * l[i] * l[j];
    s.slope.row(3 + i) = 4.0 * (l[i] * slope.row(j) + l[j] * slope.row(i));
  }
  return s;
}

/// A point of a quadrature rule: its weight, and the shape functions at the point.
struct RulePoint
{
  double weight;
  FaceShape shape;
};

/// Returns a tensor Gauss rule with n points in each direction. On triangles, the rule is collapsed
/// into a corner.
std::vector<RulePoint> makeRule(int count, int n)
{
  const GaussLegendre gauss(n);
  std::vector<RulePoint> rule;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double weight = gauss.weights()[i] * gauss.weights()[j];
      const double x = gauss.nodes()[i];
      const double y = gauss.nodes()[j];
      if (count == 4)
      {
        rule.push_back({ weight, shapeAt(4, { x, y }) });
      }
      else
      {
        const double u = 0.5 * (1.0 + x);
        const double v = 0.5 * (1.0 + y) * (1.0 - u);
        rule.push_back({ 0.25 * weight * (1.0 - u), shapeAt(count, { u, v }) });
      }
    }
  }
  return rule;
}

const std::vector<RulePoint>& ruleOf(int count, int n)
{
  using Rules = std::array<std::array<std::vector<RulePoint>, MostPoints + 1>, 7>;
  static const Rules rules = []
  {
    Rules made;
    for (const int nodes : { 3, 4, 6 })
    {
      for (int k = 1; k <= MostPoints; ++k)
      {
        made[static_cast<std::size_t>(nodes)][static_cast<std::size_t>(k)] = makeRule(nodes, k);
      }
    }
    return made;
  }();
  return rules[static_cast<std::size_t>(count)][static_cast<std::size_t>(n)];
}

FacePoint pointOf(const FaceShape& shape)
{
  FacePoint point;
  std::copy_n(shape.value.data(), 6, point.shape.begin());
  return point;
}

/// Computes the points on triangles with a corner at the origin, over the smooth surface.
void fanPoints(const LocalFace& face, std::vector<FacePoint>& points)
{
  static const GaussLegendre gauss(4);
  const auto& x = face.nodes;
  const int n = face.count;
  const int corners = n == 4 ? 4 : 3;
  const Eigen::Vector2d origin = nodePlace(n, face.own);
  for (int c = 0; c < corners; ++c)
  {
    const Eigen::Vector2d a = nodePlace(n, c) - origin;
    const Eigen::Vector2d b = nodePlace(n, (c + 1) % corners) - origin;
    if (a[0] * b[1] - a[1] * b[0] < 1e-9)
    {
      continue; // the edge passes through the origin, so its triangle has no area
    }
    for (int i = 0; i < 4; ++i)
    {
      const double s = 0.5 * (1.0 + gauss.nodes()[i]);
      const Eigen::Vector2d end = (1.0 - s) * a + s * b;
      const FaceShape far = shapeAt(n, origin + end);
      const double height = x.row(2).leftCols(n) * far.value.head(n);
      const double heightAlong =
        (x.row(2).leftCols(n) * far.slope.topRows(n)).dot((b - a).transpose());
      for (int j = 0; j < 4; ++j)
      {
        const double u = 0.5 * (1.0 + gauss.nodes()[j]);
        const FaceShape shape = shapeAt(n, origin + u * end);
        const Eigen::Matrix2d plane = x.topLeftCorner(2, n) * shape.slope.topRows(n);
        Eigen::Vector3d outward;
        outward << plane * end, 2.0 * u * height;
        Eigen::Vector3d across;
        across << u * (plane * (b - a)), u * u * heightAlong;
        FacePoint point = pointOf(shape);
        point.at << x.topLeftCorner(2, n) * shape.value.head(n), u * u * height;
        point.area = 0.25 * gauss.weights()[i] * gauss.weights()[j] * outward.cross(across);
        points.push_back(point);
      }
    }
  }
}
} // namespace

int pointsAlong(double distance, double size)
{
  const double ratio = distance / size;
  return ratio > 6.0 ? 2 : ratio > 3.0 ? 3 : ratio > 1.6 ? 4 : MostPoints;
}

void facePoints(const LocalFace& face, std::vector<FacePoint>& points)
{
  points.clear();
  if (face.own >= 0)
  {
    fanPoints(face, points);
    return;
  }
  const int n = face.count;
  const Eigen::Vector3d middle = face.nodes.leftCols(n).rowwise().mean();
  const double size = (face.nodes.leftCols(n).colwise() - middle).colwise().norm().maxCoeff();
  for (const RulePoint& rule : ruleOf(n, pointsAlong(middle.norm(), size)))
  {
    const Eigen::Matrix<double, 3, 2> tangents =
      face.nodes.leftCols(n) * rule.shape.slope.topRows(n);
    FacePoint point = pointOf(rule.shape);
    point.at = face.nodes.leftCols(n) * rule.shape.value.head(n);
    point.area = rule.weight * tangents.col(0).cross(tangents.col(1));
    points.push_back(point);
  }
}
} // namespace palpate
