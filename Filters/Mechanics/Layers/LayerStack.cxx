// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/LayerStack.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/ReducedModulus.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// At small k the two fields of a thin layer are nearly equal. For kh < 1e-3 double precision would
// lose all digits; long double keeps seven digits.
using Real = long double;
using Matrix2 = Eigen::Matrix<Real, 2, 2>;
using Matrix4 = Eigen::Matrix<Real, 4, 4>;
// Smallest k times the thickness of the thinnest layer. For smaller k a parabola is used.
constexpr double LeastWaveNumber = 1e-3;

Real shearModulus(const StackLayer& layer)
{
  return static_cast<Real>(layer.youngsModulus) / (2.0L * (1.0L + layer.poissonRatio));
}

/// The two fields that decay from a face, at the distance Z from that face: the displacements (A,
/// B), and the tractions (τ, σ) on a cut parallel to the face, divided by kμ.
struct Fields
{
  Matrix2 displacement;
  Matrix2 traction;
};
Fields fieldsAt(Real z, double nu)
{
  const Real kappa = 3.0L - 4.0L * nu;
  const Real e = std::exp(-z);
  Fields fields;
  // The first column is the field with a = 1, the second the field with b = 1.
  fields.displacement << e, z * e, e, (kappa + z) * e;
  const Real slopeA[2] = { -e, (1.0L - z) * e };
  const Real slopeB[2] = { -e, (1.0L - kappa - z) * e };
  for (int i = 0; i < 2; ++i)
  {
    fields.traction(0, i) = slopeA[i] - fields.displacement(1, i);
    fields.traction(1, i) = 2.0L * slopeB[i] - (i == 1 ? 4.0L * nu * e : 0.0L);
  }
  return fields;
}

/// Returns the stiffness matrix between the displacements of both faces and their tractions,
/// divided by k.
Matrix4 stiffness(const StackLayer& layer, Real k)
{
  const Real depth = k * static_cast<Real>(layer.thickness);
  const Fields near = fieldsAt(0.0L, layer.poissonRatio);
  const Fields far = fieldsAt(depth, layer.poissonRatio);
  Matrix2 mirror = Matrix2::Identity();
  mirror(1, 1) = -1.0L;
  Matrix4 displacement;
  displacement << near.displacement, mirror * far.displacement, far.displacement,
    mirror * near.displacement;
  Matrix4 traction; // τ and σ on cuts whose normal points down
  traction << -near.traction, mirror * far.traction, far.traction, -(mirror * near.traction);
  return shearModulus(layer) * traction * displacement.inverse();
}

Matrix2 halfSpaceStiffness(const StackLayer& halfSpace)
{
  const Fields fields = fieldsAt(0.0L, halfSpace.poissonRatio);
  return -shearModulus(halfSpace) * fields.traction * fields.displacement.inverse();
}

/// Returns the stiffness of the top of the stack at k (1/mm), divided by k.
Matrix2 topStiffness(const LayerStack& stack, Real k)
{
  Matrix2 below = stack.hasHalfSpace ? halfSpaceStiffness(stack.halfSpace) : Matrix2::Zero();
  bool slipsBelow = stack.hasHalfSpace && stack.halfSpace.slips;
  bool isRigid = !stack.hasHalfSpace;
  for (std::size_t i = stack.layers.size(); i-- > 0;)
  {
    const Matrix4 whole = stiffness(stack.layers[i], k);
    const Matrix2 top = whole.topLeftCorner<2, 2>();
    const Matrix2 across = whole.topRightCorner<2, 2>();
    Matrix2 bottom = whole.bottomRightCorner<2, 2>();
    if (isRigid && stack.base == LayerBase::Bonded)
    {
      below = top;
    }
    else if (isRigid)
    {
      below = top - across.col(0) * across.col(0).transpose() / bottom(0, 0);
    }
    else
    {
      if (slipsBelow)
      {
        const Real normal = 1.0L / below.inverse()(1, 1);
        below = Matrix2::Zero();
        below(1, 1) = normal;
      }
      bottom += below;
      below = top - across * bottom.inverse() * across.transpose();
    }
    isRigid = false;
    slipsBelow = stack.layers[i].slips;
  }
  return below;
}

/// The transforms W and V.
struct TransformPair
{
  double normal;
  double radial;
};

TransformPair transformAt(const LayerStack& stack, double omega)
{
  const StackLayer& top = stack.layers.front();
  const Matrix2 compliance =
    topStiffness(stack, static_cast<Real>(omega) / static_cast<Real>(top.thickness)).inverse();
  const double modulus = reducedModulus(top.youngsModulus, top.poissonRatio);
  return { 0.5 * modulus * static_cast<double>(compliance(1, 1)),
    -0.5 * modulus * static_cast<double>(compliance(0, 1)) };
}
} // namespace

std::string checkStack(const LayerStack& stack)
{
  if (stack.layers.empty() || stack.layers.size() > LayerStack::MostLayers)
  {
    return joined("A stack has 1 to ", LayerStack::MostLayers, " layers, but this one has ",
      stack.layers.size());
  }
  const auto check = [](const StackLayer& layer, const std::string& name, bool isEndless)
  {
    if (!isEndless && !(layer.thickness > 0.0 && std::isfinite(layer.thickness)))
    {
      return joined(
        name, ": its thickness must be positive and finite (mm), but is ", layer.thickness);
    }
    if (!(layer.youngsModulus > 0.0 && std::isfinite(layer.youngsModulus)))
    {
      return joined(
        name, ": Young's modulus must be positive and finite (MPa), but is ", layer.youngsModulus);
    }
    return isPoissonsRatio(layer.poissonRatio)
      ? std::string()
      : joined(name, ": Poisson's ratio must lie between 0 and 0.5, but is ", layer.poissonRatio);
  };
  for (std::size_t i = 0; i < stack.layers.size(); ++i)
  {
    const std::string fault = check(stack.layers[i], joined("Layer ", i), false);
    if (!fault.empty())
    {
      return fault;
    }
  }
  return stack.hasHalfSpace ? check(stack.halfSpace, "The half-space", true) : std::string();
}

StackTransform stackTransform(const LayerStack& stack, double omega)
{
  const StackLayer& top = stack.layers.front();
  const double limit = (1.0 - 2.0 * top.poissonRatio) / (2.0 * (1.0 - top.poissonRatio));
  double thinnest = top.thickness;
  for (const StackLayer& layer : stack.layers)
  {
    thinnest = std::min(thinnest, layer.thickness);
  }
  const double least = LeastWaveNumber * top.thickness / thinnest;
  if (omega >= least)
  {
    const TransformPair at = transformAt(stack, omega);
    return { at.normal - 1.0, at.radial - limit };
  }
  const TransformPair first = transformAt(stack, least);
  const TransformPair second = transformAt(stack, 2.0 * least);
  const TransformPair third = transformAt(stack, 3.0 * least);
  const double t = omega / least - 2.0;
  const auto parabola = [t](double at1, double at2, double at3)
  { return at2 + 0.5 * t * (at3 - at1) + 0.5 * t * t * (at3 - 2.0 * at2 + at1); };
  return { parabola(first.normal, second.normal, third.normal) - 1.0,
    parabola(first.radial, second.radial, third.radial) - limit };
}
} // namespace palpate
