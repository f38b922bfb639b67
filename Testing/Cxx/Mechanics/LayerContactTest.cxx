// SPDX-License-Identifier: BSD-3-Clause
// Any tool on a layer: against a dense solution of the integral equation with another quadrature
// rule, and by general properties.
#include "Mechanics/Layers/LayerContact.h"

#include "Agreement.h"
#include "Quadrature.h"
#include "TestTools.h"

#include <Eigen/LU>

#include <algorithm>

using palpate::LayerBase;
using palpate::LayerContact;
using palpate::LayerKernel;
using palpate::Pi;
using palpate::testing::agrees;
using palpate::testing::Quadrature;
using palpate::testing::tool;

namespace
{
std::shared_ptr<const LayerKernel> bonded(double nu)
{
  return std::make_shared<const LayerKernel>(nu, LayerBase::Bonded);
}

/// M(s) of a bonded layer from its definition. W - 1 is evaluated as written, without factoring out
/// an exponential.
double kernelByDefinition(double s, double nu)
{
  static const Quadrature rule(40);
  const double k = 3.0 - 4.0 * nu;
  double sum = 0.0;
  for (int panel = 0; panel < 36; ++panel)
  {
    sum += rule.integrate(0.5 * panel, 0.5 * (panel + 1),
      [&](double w)
      {
        const double d = 2 * k * std::cosh(2 * w) + 4 * w * w + 1 + k * k;
        return (2 * k * std::sinh(2 * w) - 4 * w - d) / d * std::cos(w * s);
      });
  }
  return sum;
}

const std::vector<const char*> AllShapes = { "flat:2", "paraboloid:3", "sphere:6.35", "cone:75",
  "truncated:1,75", "blunted:2,75", "rounded:2,4", "power:4,0.002",
  "profile:0,0;0.5,0.05;1.2,0.3;2,0.9;3,2" };

struct Dense
{
  double depth;
  double force; ///< for E* = 1, N
};

/// Depth and force at contact radius a, for a tool whose contact ends smoothly. Solves the equation
/// on 300 midpoints of [0, a]. The error of order n^-2 is extrapolated with the solution on 150
/// midpoints.
Dense denseSolution(const palpate::AxisymmetricTool& pressed, double nu, double h, double a)
{
  const auto onMidpoints = [&](int n) -> Dense
  {
    const double step = a / n;
    std::vector<double> kernel; // M at multiples of step/2
    for (int i = 0; i <= 4 * n; ++i)
    {
      kernel.push_back(kernelByDefinition(0.5 * i * step / h, nu));
    }
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd right(n, 2);
    Eigen::VectorXd rim(n);
    const auto m = [&](int half) { return kernel[static_cast<std::size_t>(std::abs(half))]; };
    for (int i = 0; i < n; ++i)
    {
      right(i, 0) = 1.0;
      right(i, 1) = pressed.reducedProfile((i + 0.5) * step);
      rim[i] = step / (Pi * h) * (m(2 * n + 2 * i + 1) + m(2 * n - 2 * i - 1));
      for (int j = 0; j < n; ++j)
      {
        system(i, j) += step / (Pi * h) * (m(2 * (i + j + 1)) + m(2 * (i - j)));
      }
    }
    const Eigen::MatrixXd y = system.partialPivLu().solve(right);
    const double depth =
      (pressed.reducedProfile(a) - rim.dot(y.col(1))) / (1.0 - rim.dot(y.col(0)));
    return { depth, 2.0 * step * (depth * y.col(0).sum() - y.col(1).sum()) };
  };
  const Dense coarse = onMidpoints(150);
  const Dense fine = onMidpoints(300);
  return { (4.0 * fine.depth - coarse.depth) / 3.0, (4.0 * fine.force - coarse.force) / 3.0 };
}
} // namespace

TEST(LayerKernel, TableAgreesWithTheSolution)
{
  for (const double nu : { 0.0, 0.3, 0.49, 0.5 })
  {
    const LayerKernel kernel(nu, LayerBase::Bonded);
    for (double ratio = 0.013; ratio <= LayerKernel::LargestRatio; ratio *= 1.17)
    {
      const auto table = kernel.at(ratio);
      const auto exact = kernel.solve(ratio);
      // The header guarantees 1e-10.
      EXPECT_LT((table.flat - exact.flat).abs().maxCoeff(), 1e-10 * exact.flat.abs().maxCoeff())
        << nu << ' ' << ratio;
      EXPECT_LT((table.resolvent - exact.resolvent).abs().maxCoeff(),
        1e-10 * std::max(1.0, exact.resolvent.abs().maxCoeff()))
        << nu << ' ' << ratio;
    }
    EXPECT_EQ(kernel.at(0.0).flat.size(), LayerKernel::NodeCount);
    EXPECT_NEAR(kernel.at(0.0).flat[7], 1.0, 1e-13); // the solution for the half-space
    EXPECT_TRUE(std::isnan(kernel.at(-0.1).flat[0]));
    EXPECT_TRUE(std::isnan(kernel.at(10.1).flat[0]));
    EXPECT_TRUE(std::isnan(kernel.at(std::nan("")).flat[0]));
  }
}

TEST(LayerKernel, KernelByDefinition)
{
  for (const double nu : { 0.0, 0.25, 0.5 })
  {
    const LayerKernel kernel(nu, LayerBase::Bonded);
    for (const double s : { 0.0, 0.1, 0.77, 1.0, 2.5, 6.0, 13.0 })
    {
      // Both functions add about a thousand terms of order 1.
      EXPECT_NEAR(kernel.normal(s), kernelByDefinition(s, nu), 1e-12) << nu << ' ' << s;
    }
  }
}

TEST(LayerContact, DenseSolution)
{
  for (const char* name : { "sphere:6.35", "cone:60", "paraboloid:3" })
  {
    const auto pressed = tool(name);
    for (const double nu : { 0.1, 0.5 })
    {
      for (const double a : { 0.8, 3.0, 6.0 })
      {
        SCOPED_TRACE(std::string(name) + ", a = " + std::to_string(a));
        const Dense dense = denseSolution(*pressed, nu, 2.0, a);
        const LayerContact contact(*pressed, bonded(nu), 2.0);
        const auto point = contact.evaluate(dense.depth, 1.0);
        // Extrapolated midpoints have an error of O(n^-4). The sphere has a larger error because of
        // the logarithm near its equator.
        EXPECT_TRUE(agrees(contact.depthAtContactRadius(a), dense.depth, 2e-7));
        EXPECT_TRUE(agrees(point.contactRadius, a, 2e-7));
        EXPECT_TRUE(agrees(point.force, dense.force, 1e-6));
      }
    }
  }
}

// Tools whose reduced profile has kinks. Solves the integral equation on the nodes of panels
// between the kinks; the library never sets up this system. The kernel M is that of the library,
// which KernelByDefinition tests.
TEST(LayerContact, KinkedTools)
{
  const Quadrature rule(40);
  const LayerKernel kernel(0.4, LayerBase::Bonded);
  const double h = 3.0;
  for (const char* name : { "truncated:1,70", "blunted:2,60", "rounded:2,1", "power:4,0.01",
         "profile:0,0;0.5,0.05;1.2,0.3;2,0.9;3,2" })
  {
    const auto pressed = tool(name);
    const LayerContact contact(*pressed, bonded(0.4), h);
    for (const double a : { 1.15, 2.3, 2.9 })
    {
      if (a <= pressed->smallestContactRadius())
      {
        continue;
      }
      SCOPED_TRACE(std::string(name) + ", a = " + std::to_string(a));
      std::vector<double> x;
      std::vector<double> weights;
      std::vector<double> ends = pressed->kinks();
      ends.erase(
        std::remove_if(ends.begin(), ends.end(), [a](double k) { return k >= a; }), ends.end());
      ends.push_back(a);
      double begin = 0.0;
      for (const double end : ends)
      {
        rule.forEachNode(
          [&](double u, double weight)
          {
            x.push_back(begin + (end - begin) * u * u);
            weights.push_back(2.0 * u * weight * (end - begin));
          });
        begin = end;
      }
      const auto n = static_cast<Eigen::Index>(x.size());
      const auto m = [&](double from, double to) {
        return (kernel.normal((from + to) / h) + kernel.normal(std::abs(from - to) / h)) / (Pi * h);
      };
      Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n, n);
      Eigen::MatrixXd right(n, 2);
      Eigen::VectorXd rim(n);
      const auto at = [](const std::vector<double>& v, Eigen::Index i)
      { return v[static_cast<std::size_t>(i)]; };
      for (Eigen::Index i = 0; i < n; ++i)
      {
        right(i, 0) = 1.0;
        right(i, 1) = pressed->reducedProfile(at(x, i));
        rim[i] = at(weights, i) * m(a, at(x, i));
        for (Eigen::Index j = 0; j < n; ++j)
        {
          system(i, j) += at(weights, j) * m(at(x, i), at(x, j));
        }
      }
      const Eigen::MatrixXd y = system.partialPivLu().solve(right);
      const double depth =
        (pressed->reducedProfile(a) - rim.dot(y.col(1))) / (1.0 - rim.dot(y.col(0)));
      const Eigen::Map<const Eigen::VectorXd> w(weights.data(), n);
      const double force = 2.0 * w.dot(depth * y.col(0) - y.col(1));
      const auto point = contact.evaluate(depth, 1.0);
      // Both rules resolve the parts of g to about 1e-10; a profile with many corners has 8 nodes
      // per part.
      EXPECT_TRUE(agrees(point.contactRadius, a, 1e-8));
      EXPECT_TRUE(agrees(point.force, force, 1e-9));
    }
  }
}

TEST(LayerContact, StiffnessIsTheSlopeOfTheForce)
{
  for (const char* name : AllShapes)
  {
    const auto pressed = tool(name);
    const LayerContact contact(*pressed, bonded(0.45), 3.0);
    for (const double depth : { 1e-3, 0.1, 0.7, 2.0 })
    {
      const double step = 1e-4 * depth;
      const double slope =
        (contact.evaluate(depth + step, 2.0).force - contact.evaluate(depth - step, 2.0).force) /
        (2.0 * step);
      // Truncation of the central difference: step²/6 · F‴/F′ ≤ 1e-8. Rounding: 1e-13/1e-4.
      EXPECT_TRUE(agrees(contact.evaluate(depth, 2.0).stiffness, slope, 2e-8)) << name << depth;
    }
  }
}

TEST(LayerContact, ThickLayerIsAHalfSpace)
{
  for (const char* name : AllShapes)
  {
    const auto pressed = tool(name);
    const LayerContact contact(*pressed, bonded(0.2), 1e6);
    const auto found = contact.evaluate(0.5, 3.0);
    const auto expected = pressed->evaluate(0.5, 3.0);
    // A base at 1e6 mm increases the stiffness by at most (2|M0|/π) a/h = 3e-6.
    EXPECT_TRUE(agrees(found.force, expected.force, 1e-5)) << name;
    EXPECT_GT(found.force, expected.force) << name;
    EXPECT_TRUE(agrees(found.contactRadius, expected.contactRadius, 1e-5)) << name;
  }
}

// A wide tool on a thin, compressible layer presses independent columns: p = M (δ - f)/h with the
// oedometric modulus M. For a flat end F = π a² M δ/h.
TEST(LayerContact, ThinLayerIsAMattress)
{
  const double nu = 0.2;
  const auto flat = tool("flat:10");
  const double oedometric = (1.0 - nu) * (1.0 - nu) / (1.0 - 2.0 * nu); // for E* = 1
  const auto edge = [&](double h)
  {
    const LayerContact contact(*flat, bonded(nu), h);
    return contact.evaluate(0.1, 1.0).force / (Pi * 100.0 * oedometric * 0.1 / h) - 1.0;
  };
  // The effect of the rim is proportional to h/a.
  EXPECT_NEAR(edge(1.0) / edge(2.0), 0.5, 0.03);
  EXPECT_NEAR(2.0 * edge(1.0) - edge(2.0), 0.0, 0.01);
}

TEST(LayerContact, DeepestAndBeyond)
{
  const auto cone = tool("cone:60");
  const LayerContact thin(*cone, bonded(0.3), 0.5); // the law is valid up to a = 5
  EXPECT_GT(thin.deepest(), 0.0);
  EXPECT_TRUE(agrees(thin.contactRadius(thin.deepest()), 5.0, 1e-9));
  EXPECT_TRUE(std::isnan(thin.evaluate(1.01 * thin.deepest(), 1.0).force));
  EXPECT_TRUE(std::isnan(thin.depthAtContactRadius(5.01)));

  const auto flat = tool("flat:2");
  EXPECT_TRUE(std::isinf(LayerContact(*flat, bonded(0.3), 0.21).deepest()));
  EXPECT_EQ(LayerContact(*flat, bonded(0.3), 0.19).deepest(), 0.0);
  EXPECT_TRUE(std::isnan(LayerContact(*flat, bonded(0.3), 0.19).evaluate(0.1, 1.0).force));
  EXPECT_EQ(LayerContact(*flat, bonded(0.3), 1.0).depthAtContactRadius(1.0), 0.0);

  const auto sphere = tool("sphere:3"); // with its wall: a < 3 at any depth
  const LayerContact contact(*sphere, bonded(0.3), 1.0);
  EXPECT_TRUE(std::isinf(contact.deepest()));
  EXPECT_LE(contact.contactRadius(20.0), 3.0);
  EXPECT_GT(contact.contactRadius(20.0), 2.99);
  EXPECT_TRUE(std::isinf(contact.depthAtContactRadius(3.0)));

  EXPECT_EQ(contact.evaluate(0.0, 1.0).force, 0.0);
  EXPECT_EQ(contact.evaluate(-1.0, 1.0).stiffness, 0.0);
  EXPECT_TRUE(std::isnan(contact.evaluate(std::nan(""), 1.0).force));
}

TEST(LayerContact, TinyDepths)
{
  for (const char* name : { "paraboloid:3", "sphere:6.35", "cone:75" })
  {
    const auto pressed = tool(name);
    const LayerContact contact(*pressed, bonded(0.5), 3.0);
    for (const double depth : { 1e-12, 1e-9, 1e-6 })
    {
      // a/h is at most about 1e-3. The force is that of the half-space, to (2|M0|/π) a/h.
      EXPECT_TRUE(agrees(contact.evaluate(depth, 1.0).force, pressed->force(depth, 1.0), 5e-3))
        << name << depth;
    }
  }
}
