// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/InclusionLoad.h"

#include "Mechanics/Numerics/GaussLegendre.h"
#include "Solids/TrueShape/FaceRule.h"

namespace palpate
{
namespace
{
struct VolumePoint
{
  Eigen::Vector3d xi;
  double weight;
};

/// Returns a tensor Gauss rule on [-1, 1]³. On the unit tetrahedron, the rule is collapsed into a
/// corner.
std::vector<VolumePoint> makeVolumeRule(bool hexahedron, int n)
{
  const GaussLegendre gauss(n);
  std::vector<VolumePoint> rule;
  for (int i = 0; i < n * n * n; ++i)
  {
    const Eigen::Array3i at(i % n, i / n % n, i / (n * n));
    const Eigen::Vector3d x(gauss.nodes()[at[0]], gauss.nodes()[at[1]], gauss.nodes()[at[2]]);
    const double weight = gauss.weights()[at[0]] * gauss.weights()[at[1]] * gauss.weights()[at[2]];
    if (hexahedron)
    {
      rule.push_back({ x, weight });
      continue;
    }
    const Eigen::Vector3d u = 0.5 * (x.array() + 1.0);
    const double v = u[1] * (1.0 - u[0]);
    const double w = u[2] * (1.0 - u[0]) * (1.0 - u[1]);
    rule.push_back({ { u[0], v, w }, 0.125 * weight * (1.0 - u[0]) * (1.0 - u[0]) * (1.0 - u[1]) });
  }
  return rule;
}

const std::vector<VolumePoint>& volumeRule(ElementKind kind, int n)
{
  using Rules = std::array<std::vector<VolumePoint>, MostPoints + 1>;
  static const std::array<Rules, 2> rules = []
  {
    std::array<Rules, 2> made;
    for (int k = 1; k <= MostPoints; ++k)
    {
      made[0][static_cast<std::size_t>(k)] = makeVolumeRule(false, k);
      made[1][static_cast<std::size_t>(k)] = makeVolumeRule(true, k);
    }
    return made;
  }();
  return rules[kind == ElementKind::Hexahedron ? 1 : 0][static_cast<std::size_t>(n)];
}
} // namespace

ElementNodes inclusionLoad(ElementKind kind, const ElementNodes& nodes,
  const ElasticMaterial& material, const ElasticMaterial& around, const BoussinesqField& field)
{
  const auto shear = [](const ElasticMaterial& m)
  { return m.youngsModulus / (2.0 * (1.0 + m.poissonRatio)); };
  const auto lambda = [&shear](const ElasticMaterial& m)
  { return 2.0 * shear(m) * m.poissonRatio / (1.0 - 2.0 * m.poissonRatio); };
  const double twice = 2.0 * (shear(material) - shear(around));
  const double dilated = lambda(material) - lambda(around);

  const Eigen::Vector3d middle = nodes.rowwise().mean();
  const double size = (nodes.colwise() - middle).colwise().norm().maxCoeff();
  ElementGradients gradients;
  ElementGradients sum(3, nodes.cols() + (kind == ElementKind::Hexahedron ? 3 : 0));
  sum.setZero();
  for (const VolumePoint& point : volumeRule(kind, pointsAlong(middle.norm(), size)))
  {
    const double determinant = elementGradients(kind, nodes, point.xi, gradients);
    const Eigen::Matrix3d strain = field.strain(nodes * elementShapes(kind, point.xi));
    Eigen::Matrix3d stress = twice * strain;
    stress.diagonal().array() += dilated * strain.trace();
    sum -= (point.weight * determinant * stress) * gradients;
  }
  ElementNodes forces = sum.leftCols(nodes.cols());
  if (kind == ElementKind::Hexahedron)
  {
    const Eigen::Matrix<double, 3, 3> onModes = sum.rightCols<3>();
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> f(onModes.data());
    const Eigen::Matrix<double, 24, 1> condensed = modesOfNodes(nodes, material).transpose() * f;
    forces += Eigen::Map<const Eigen::Matrix<double, 3, 8>>(condensed.data());
  }
  return forces;
}
} // namespace palpate
