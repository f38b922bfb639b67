// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ShapedBodies_h
#define palpate_testing_ShapedBodies_h

#include "ElasticBlocks.h"
#include "Solids/TrueShape/ContactKernelFit.h"
#include "Solids/TrueShape/ShapedContact.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace palpate::testing
{
/// A block of hexahedra with nodes at three ascending lists of coordinates.
inline VolumeMesh gridBlock(
  const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z)
{
  VolumeMesh mesh = hexahedronBlock(static_cast<int>(x.size()) - 1, static_cast<int>(y.size()) - 1,
    static_cast<int>(z.size()) - 1, 1.0);
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    const auto at = [&](int axis) { return static_cast<std::size_t>(mesh.nodes(axis, i) + 0.5); };
    mesh.nodes.col(i) << x[at(0)], y[at(1)], z[at(2)];
  }
  return mesh;
}

/// Coordinates from 0 outwards in both directions: steps of `side` up to `fine`, then steps that
/// grow by the factor `ratio`, up to `end`.
inline std::vector<double> gradedLine(double side, double fine, double ratio, double end)
{
  std::vector<double> half = { 0.0 };
  double step = side;
  while (half.back() < end - 1e-9)
  {
    step *= half.back() >= fine - 1e-9 ? ratio : 1.0;
    const double next = half.back() + step;
    half.push_back(next > end - 0.5 * step ? end : next);
  }
  std::vector<double> line;
  for (std::size_t i = half.size(); i-- > 1;)
  {
    line.push_back(-half[i]);
  }
  line.insert(line.end(), half.begin(), half.end());
  return line;
}

/// The non-negative coordinates of gradedLine().
inline std::vector<double> gradedHalf(double side, double fine, double ratio, double end)
{
  const std::vector<double> line = gradedLine(side, fine, ratio, end);
  return std::vector<double>(
    line.begin() + static_cast<std::ptrdiff_t>(line.size() / 2), line.end());
}

/// Heights from 0 to `top`, with the smallest steps at the top.
inline std::vector<double> gradedDepth(double side, double fine, double ratio, double top)
{
  std::vector<double> heights;
  const std::vector<double> depths = gradedHalf(side, fine, ratio, top);
  for (std::size_t i = depths.size(); i-- > 0;)
  {
    heights.push_back(i + 1 == depths.size() ? 0.0 : top - depths[i]);
  }
  return heights;
}

/// A body of one material, held at x = 0 and at x = `length`.
inline ElasticBodyInput heldAtTheEnds(VolumeMesh mesh, double length)
{
  std::vector<unsigned char> fixed;
  for (Eigen::Index i = 0; i < mesh.nodes.cols(); ++i)
  {
    fixed.push_back(mesh.nodes(0, i) == 0.0 || mesh.nodes(0, i) == length ? 7 : 0);
  }
  return { std::move(mesh), { { 0.1, 0.45 } }, fixed };
}

/// Relative error of a force that shapedResponse() states for the elements, the order of the fit
/// and the tilt near an edge. `exponent`: d ln F / d ln δ.
inline double statedOfElements(const ContactSample& errors, double exponent)
{
  constexpr double leftOfTilt = 0.2;
  return std::hypot(errors.elements(), leftOfTilt * errors.harmonics * exponent);
}

/// A factorised body with its Green function for contacts at one place.
struct ShapedBody
{
  ElasticBody body;
  std::unique_ptr<RegularGreen> green;
  std::unique_ptr<ContactKernelFit> fit;

  ShapedBody(
    ElasticBodyInput input, const Eigen::Vector3d& place, double radius, double spacing = 0.0)
  {
    EXPECT_EQ(this->body.assemble(std::move(input)), "");
    EXPECT_EQ(this->body.analyse(StiffnessFactor::Kind::Automatic), "");
    EXPECT_EQ(this->body.factorise(), "");
    const std::int32_t point = pointAt(this->body.surface(), place);
    this->green = std::make_unique<RegularGreen>(this->body);
    EXPECT_EQ(this->green->solve(
                { point }, radius, [](double) { return true; }, spacing),
      "");
    this->fit = std::make_unique<ContactKernelFit>(*this->green, point);
  }
};
} // namespace palpate::testing

#endif
