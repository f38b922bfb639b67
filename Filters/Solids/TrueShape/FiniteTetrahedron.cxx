// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/FiniteTetrahedron.h"

#include <Eigen/LU>

#include <cmath>

namespace palpate
{
namespace
{
struct Moduli
{
  explicit Moduli(const ElasticMaterial& material)
    : shear(0.5 * material.youngsModulus / (1.0 + material.poissonRatio))
    , bulk(material.youngsModulus / (3.0 - 6.0 * material.poissonRatio))
  {
  }
  double shear;
  double bulk;
};

using Displacements = Eigen::Map<const Eigen::Matrix<double, 3, 10>>;

/// Returns the deformation gradient F.
Eigen::Matrix3d deformation(const Displacements& u, const Eigen::Matrix<double, 3, 10>& gradients)
{
  return Eigen::Matrix3d::Identity() + u * gradients.transpose();
}

/// The derivative dP/dF. The entry (j, b) of block (i, a) is ∂P_ij/∂F_ab.
struct Tangent
{
  Tangent(const Moduli& moduli, const Eigen::Matrix3d& f, const Eigen::Matrix3d& g, double j)
  {
    const double trace = f.squaredNorm();
    const double shear = moduli.shear / std::cbrt(j * j);
    const double both = 2.0 / 9.0 * shear * trace + moduli.bulk * j * (2.0 * j - 1.0);
    const double crossed = shear * trace / 3.0 - moduli.bulk * j * (j - 1.0);
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      for (Eigen::Index a = 0; a < 3; ++a)
      {
        Eigen::Matrix3d& block = this->blocks[static_cast<std::size_t>(3 * i + a)];
        block = both * g.row(i).transpose() * g.row(a) + crossed * g.row(a).transpose() * g.row(i) -
          2.0 / 3.0 * shear * (f.row(i).transpose() * g.row(a) + g.row(i).transpose() * f.row(a));
        if (i == a)
        {
          block.diagonal().array() += shear;
        }
      }
    }
  }
  std::array<Eigen::Matrix3d, 9> blocks;
};
} // namespace

FiniteTetrahedron::FiniteTetrahedron(const ElementNodes& nodes)
{
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    ElementGradients gradients;
    const double determinant = elementGradients(
      ElementKind::QuadraticTetrahedron, nodes, quadraticPoint(static_cast<int>(i)), gradients);
    this->Points[i] = { gradients, determinant / 24.0 };
  }
}

double FiniteTetrahedron::energy(const ElasticMaterial& material, const Vector& u) const
{
  const Moduli moduli(material);
  double sum = 0.0;
  for (const Point& point : this->Points)
  {
    const Eigen::Matrix3d f = deformation(Displacements(u.data()), point.gradients);
    const double j = f.determinant();
    if (!(j > 0.0))
    {
      return HUGE_VAL;
    }
    sum += point.weight *
      (0.5 * moduli.shear * (f.squaredNorm() / std::cbrt(j * j) - 3.0) +
        0.5 * moduli.bulk * (j - 1.0) * (j - 1.0));
  }
  return sum;
}

void FiniteTetrahedron::linearize(
  const ElasticMaterial& material, const Vector& u, Vector& forces, ElementMatrix& stiffness) const
{
  const Moduli moduli(material);
  Eigen::Map<Eigen::Matrix<double, 3, 10>> force(forces.data());
  forces.setZero();
  stiffness.setZero(30, 30);
  for (const Point& point : this->Points)
  {
    const Eigen::Matrix3d f = deformation(Displacements(u.data()), point.gradients);
    const double j = f.determinant();
    const Eigen::Matrix3d g = f.inverse().transpose();
    const Eigen::Matrix3d stress =
      moduli.shear / std::cbrt(j * j) * (f - f.squaredNorm() / 3.0 * g) +
      moduli.bulk * (j - 1.0) * j * g;
    force += point.weight * stress * point.gradients;
    const Tangent tangent(moduli, f, g, j);
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      for (Eigen::Index a = 0; a <= i; ++a)
      {
        const Eigen::Matrix<double, 3, 10> half =
          point.weight * tangent.blocks[static_cast<std::size_t>(3 * i + a)] * point.gradients;
        const Eigen::Matrix<double, 10, 10> block = point.gradients.transpose() * half;
        for (Eigen::Index m = 0; m < 10; ++m)
        {
          for (Eigen::Index n = 0; n < 10; ++n)
          {
            stiffness(3 * n + i, 3 * m + a) += block(n, m);
            if (a != i)
            {
              stiffness(3 * m + a, 3 * n + i) += block(n, m);
            }
          }
        }
      }
    }
  }
}
} // namespace palpate
