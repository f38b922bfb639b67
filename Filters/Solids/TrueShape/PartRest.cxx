// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/TrueShape/PartRest.h"

#include "Mechanics/ReducedModulus.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace palpate
{
namespace
{
constexpr double LeastMotion = 0.005;

/// Rows: forces and moments, or motions. Columns: loads.
using Loads = Eigen::Matrix<double, 6, 6>;

/// Returns the translation and rotation of a place under loads. It is the rigid motion that best
/// fits the motions of the pieces of the place.
Loads motionOfPlace(const ElasticBody& part, const std::vector<SurfacePiece>& place,
  const Eigen::MatrixXd& motion, const Eigen::Vector3d& about)
{
  Loads normal = Loads::Zero();
  Loads moved = Loads::Zero();
  for (const SurfacePiece& piece : place)
  {
    Eigen::Vector3d at = -about;
    Eigen::Matrix<double, 3, 6> own = Eigen::Matrix<double, 3, 6>::Zero();
    for (std::size_t n = 0; n < piece.nodes.size(); ++n)
    {
      at += piece.shape[n] * part.mesh().nodes.col(piece.nodes[n]);
      own += piece.shape[n] * motion.middleRows<3>(3 * piece.nodes[n]);
    }
    Eigen::Matrix<double, 3, 6> rigid;
    rigid << 1, 0, 0, 0, at[2], -at[1], 0, 1, 0, -at[2], 0, at[0], 0, 0, 1, at[1], -at[0], 0;
    normal += piece.weight * rigid.transpose() * rigid;
    moved += piece.weight * rigid.transpose() * own;
  }
  return normal.ldlt().solve(moved);
}

/// Returns twice the energy that the part itself stores under the motions.
Loads storedInPart(const ElasticBody& part, const Eigen::MatrixXd& motion)
{
  Loads stored = Loads::Zero();
  ElementMatrix stiffness;
  for (std::int32_t e = 0; e < part.mesh().elementTotal(); ++e)
  {
    const VolumeElement& element = part.mesh().elements[static_cast<std::size_t>(e)];
    elementStiffness(element.kind, elementNodes(part.mesh(), element), part.material(e), stiffness);
    Eigen::MatrixXd moved(stiffness.rows(), 6);
    for (Eigen::Index i = 0; i < stiffness.rows() / 3; ++i)
    {
      moved.middleRows<3>(3 * i) =
        motion.middleRows<3>(3 * element.nodes[static_cast<std::size_t>(i)]);
    }
    stored += moved.transpose() * stiffness * moved;
  }
  return stored;
}

/// Returns, as columns, the combinations of loads under which the motion of the place is large
/// enough.
Eigen::Matrix<double, 6, Eigen::Dynamic> loadsThatMove(
  const Loads& place, const ElasticMaterial& material, double radius)
{
  Eigen::Matrix<double, 6, 1> arms;
  arms << 1.0, 1.0, 1.0, radius, radius, radius;
  const Loads motion = 0.5 * arms.asDiagonal() * (place + place.transpose()) * arms.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Loads> kinds(motion);
  const double least =
    LeastMotion / (2.0 * reducedModulus(material.youngsModulus, material.poissonRatio) * radius);
  const Eigen::Index left = (kinds.eigenvalues().array() > least).count();
  return arms.asDiagonal() * kinds.eigenvectors().rightCols(left);
}
} // namespace

PartRest restAround(const ElasticBody& part, const std::vector<SurfacePiece>& place,
  const UnitMotion& moved, double radius)
{
  const Eigen::Index nodes = part.mesh().nodes.cols();
  Eigen::MatrixXd motion(3 * nodes, 6);
  for (std::size_t k = 0; k < moved.nodes.size(); ++k)
  {
    motion.col(static_cast<Eigen::Index>(k)) =
      Eigen::Map<const Eigen::VectorXd>(moved.nodes[k].data(), 3 * nodes);
  }
  const Loads ofPlace = motionOfPlace(part, place, motion, moved.about);
  const Loads around = ofPlace - storedInPart(part, motion);
  const Eigen::Matrix<double, 6, Eigen::Dynamic> loads =
    loadsThatMove(ofPlace, part.material(0), radius);
  PartRest rest;
  rest.motion = motion * loads;
  rest.energy = 0.5 * loads.transpose() * (around + around.transpose()) * loads;
  rest.turns = ofPlace.bottomRows<3>() * loads;
  return rest;
}
} // namespace palpate
