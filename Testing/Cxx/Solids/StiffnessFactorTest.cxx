// SPDX-License-Identifier: BSD-3-Clause
// Both factorisations against a dense solution; floating parts; matrices that cannot be factorised.
#include "Agreement.h"
#include "ElasticBlocks.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <vector>

namespace stiffness_factor
{
namespace
{
using namespace palpate;
using palpate::testing::agrees;
using Kind = StiffnessFactor::Kind;

struct Small
{
  VolumeMesh mesh = palpate::testing::hexahedronBlock(4, 3, 3, 1.0);
  std::vector<unsigned char> fixed = palpate::testing::heldBelow(this->mesh);
  MeshTopology topology;
  StiffnessMatrix stiffness;

  Small()
  {
    this->topology.build(this->mesh);
    assembleStiffness(this->mesh, this->topology, { { 1.0, 0.3 } }, this->fixed, this->stiffness);
  }

  /// Loads on one to seven unknowns, distributed over the body. There are enough loads for several
  /// blocks.
  std::vector<SparseLoad> loads() const
  {
    std::vector<SparseLoad> made;
    const auto n = static_cast<int>(this->stiffness.lower.rows());
    for (int i = 0; i < 300; ++i)
    {
      SparseLoad load;
      for (int k = 0; k <= i % 7; ++k)
      {
        load.emplace_back((17 * i + 5 * k) % n, 1.0 + 0.1 * k);
      }
      made.push_back(load);
    }
    made.emplace_back(); // a load without entries
    return made;
  }
};

bool always(double)
{
  return true;
}
} // namespace

TEST(StiffnessFactor, CompliancesAreThoseOfTheDenseMatrix)
{
  const Small small;
  const Eigen::MatrixXd dense = small.stiffness.lower.selfadjointView<Eigen::Lower>() *
    Eigen::MatrixXd::Identity(small.stiffness.lower.rows(), small.stiffness.lower.rows());
  const Eigen::LLT<Eigen::MatrixXd> exact(dense);
  const std::vector<SparseLoad> loads = small.loads();
  for (const Kind kind : { Kind::Supernodal, Kind::Simplicial })
  {
    const auto factor = StiffnessFactor::make(kind);
    if (!factor)
    {
      EXPECT_EQ(kind, Kind::Supernodal); // this build has no CHOLMOD
      continue;
    }
    ASSERT_TRUE(factor->analyse(small.stiffness.lower));
    ASSERT_TRUE(factor->factorise(small.stiffness.lower));
    const std::vector<double> found = factor->compliances(loads, always);
    ASSERT_EQ(found.size(), loads.size());
    for (std::size_t i = 0; i < loads.size(); ++i)
    {
      Eigen::VectorXd b = Eigen::VectorXd::Zero(dense.rows());
      for (const auto& [unknown, force] : loads[i])
      {
        b[unknown] += force;
      }
      // Condition number of the matrix, about 1e4, times rounding.
      EXPECT_TRUE(agrees(found[i], b.dot(exact.solve(b)), 1e-11)) << i;
      if (i < 3)
      {
        EXPECT_LT((factor->solve(b) - exact.solve(b)).norm(), 1e-11 * exact.solve(b).norm());
      }
    }
    const Eigen::MatrixXd many = Eigen::MatrixXd::Random(dense.rows(), 5);
    EXPECT_LT(
      (factor->solveAll(many) - exact.solve(many)).norm(), 1e-11 * exact.solve(many).norm());
    // The memory is at least that of the lower triangle of K, and at most that of K with its
    // factor.
    const auto n = static_cast<double>(dense.rows());
    EXPECT_GT(
      factor->memoryEstimate(), 8.0 * static_cast<double>(small.stiffness.lower.nonZeros()));
    EXPECT_LT(factor->memoryEstimate(), 24.0 * n * n);
  }
}

TEST(StiffnessFactor, StopsWhenToldTo)
{
  const Small small;
  const auto factor = StiffnessFactor::make(Kind::Automatic);
  ASSERT_TRUE(factor->analyse(small.stiffness.lower));
  ASSERT_TRUE(factor->factorise(small.stiffness.lower));
  EXPECT_TRUE(factor->compliances(small.loads(), [](double) { return false; }).empty());
  double last = 0.0;
  factor->compliances(small.loads(),
    [&last](double done)
    {
      EXPECT_GT(done, last);
      last = done;
      return true;
    });
  EXPECT_EQ(last, 1.0);
}

TEST(StiffnessFactor, RefusesWhatIsNotPositiveDefinite)
{
  Small small;
  small.stiffness.lower.coeffRef(20, 20) = -1.0;
  for (const Kind kind : { Kind::Supernodal, Kind::Simplicial })
  {
    const auto factor = StiffnessFactor::make(kind);
    if (factor)
    {
      ASSERT_TRUE(factor->analyse(small.stiffness.lower));
      EXPECT_FALSE(factor->factorise(small.stiffness.lower));
    }
  }
}

TEST(FloatingPart, IsNamedWithTheMotionsLeft)
{
  VolumeMesh mesh = palpate::testing::hexahedronBlock(1, 1, 1, 1.0);
  VolumeMesh other = mesh;
  other.nodes.row(0).array() += 3.0;
  mesh.nodes.conservativeResize(3, 16);
  mesh.nodes.rightCols(8) = other.nodes;
  mesh.elements.push_back(mesh.elements.front());
  for (std::size_t i = 0; i < 8; ++i)
  {
    mesh.elements[1].nodes[i] += 8;
  }
  MeshTopology topology;
  ASSERT_EQ(topology.build(mesh), "");
  std::vector<unsigned char> fixed(16, 0);
  const auto fault = [&] { return findFloatingPart(mesh, topology, fixed); };

  for (std::size_t i = 0; i < 8; ++i)
  {
    fixed[i] = 7;
  }
  EXPECT_NE(fault().find("cell 1 is floating"), std::string::npos) << fault();
  EXPECT_NE(fault().find("6 of 6"), std::string::npos) << fault();
  fixed[8] = 7; // one corner is held: three rotations remain
  EXPECT_NE(fault().find("3 of 6"), std::string::npos) << fault();
  fixed[9] = 7; // an edge is held: the rotation about the edge remains
  EXPECT_NE(fault().find("1 of 6"), std::string::npos) << fault();
  fixed[10] = FixedZ;
  EXPECT_EQ(fault(), "");
  fixed[0] = fixed[1] = 0; // the remaining six points still hold the first part
  EXPECT_EQ(fault(), "");
}

TEST(MeshTopology, AFaceOfThreeElementsIsAFault)
{
  VolumeMesh mesh = palpate::testing::hexahedronBlock(2, 1, 1, 1.0);
  mesh.elements.push_back(mesh.elements.back());
  MeshTopology topology;
  EXPECT_NE(topology.build(mesh).find("more than two cells share a face"), std::string::npos);
}

/// A cube that has only an edge in common with the held cube is not held, unless a third cube has
/// faces in common with both.
TEST(MeshTopology, WhatHangsByAnEdgeIsNotHeld)
{
  VolumeMesh mesh = palpate::testing::hexahedronBlock(2, 1, 2, 1.0);
  // Order of the elements: below left, below right, above left, above right.
  const VolumeElement aboveRight = mesh.elements[3];
  std::vector<unsigned char> held(static_cast<std::size_t>(mesh.nodeTotal()), 0);
  for (std::int32_t i = 0; i < mesh.nodeTotal(); ++i)
  {
    held[static_cast<std::size_t>(i)] = mesh.nodes(2, i) == 0.0 && mesh.nodes(0, i) < 1.5 ? 1 : 0;
  }
  const auto kept = [&]
  {
    MeshTopology topology;
    EXPECT_EQ(topology.build(mesh), "");
    return elementsHeldByFaces(mesh, topology, held);
  };
  EXPECT_EQ(kept(), (std::vector<std::int32_t>{ 0, 1, 2, 3 }));
  mesh.elements = { aboveRight, mesh.elements[0] };
  EXPECT_EQ(kept(), std::vector<std::int32_t>{ 1 });
  mesh.elements = palpate::testing::hexahedronBlock(2, 1, 2, 1.0).elements;
  mesh.elements = { aboveRight, mesh.elements[0], mesh.elements[2] };
  EXPECT_EQ(kept(), (std::vector<std::int32_t>{ 0, 1, 2 }));
  std::fill(held.begin(), held.end(), 0);
  EXPECT_TRUE(kept().empty());
}
} // namespace stiffness_factor
