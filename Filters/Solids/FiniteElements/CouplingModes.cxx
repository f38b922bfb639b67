// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/CouplingModes.h"

#include "Solids/FiniteElements/GlobalModes.h"
#include "Solids/FiniteElements/RegularField.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
/// Returns landmarks. The first is the valid point with the largest compliance. Each further
/// landmark is the valid point that is farthest from all landmarks chosen before.
std::vector<std::int32_t> landmarksOf(
  const BodySurface& surface, const PatchCompliances& compliances, std::size_t wanted)
{
  std::vector<std::int32_t> valid;
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    if (compliances.status[static_cast<std::size_t>(i)] == PatchStatus::Valid)
    {
      valid.push_back(i);
    }
  }
  const auto softer = [&](std::int32_t a, std::int32_t b)
  {
    return compliances.compliance[static_cast<std::size_t>(a)] <
      compliances.compliance[static_cast<std::size_t>(b)];
  };
  return valid.empty()
    ? valid
    : spreadPoints(surface, valid, *std::max_element(valid.begin(), valid.end(), softer), wanted);
}

/// Returns the root mean square error of the modes between different landmarks, relative to the
/// exact values.
double neglectedBetween(const Eigen::MatrixXd& exact, const Eigen::MatrixXd& modes)
{
  Eigen::MatrixXd whole = exact;
  whole.diagonal().setZero();
  Eigen::MatrixXd missed = exact - modes.transpose() * modes;
  missed.diagonal().setZero();
  return whole.norm() > 0.0 ? missed.norm() / whole.norm() : 0.0;
}
} // namespace

CouplingModes couplingModes(const ElasticBody& body, const PatchCompliances& compliances,
  double radius, int count, const WorkObserver& observer)
{
  const BodySurface& surface = body.surface();
  const Eigen::Index wanted = std::clamp(count, 1, MostCouplingModes);
  const std::vector<std::int32_t> landmarks =
    landmarksOf(surface, compliances, static_cast<std::size_t>(wanted) * LandmarksPerMode);
  const auto total = static_cast<Eigen::Index>(landmarks.size());
  Eigen::MatrixXd pulled(total, surface.pointTotal()); // n_i·H(x_i, X_j) n_j, one row per landmark
  const RegularField field(body, radius);
  for (Eigen::Index j = 0; j < total; ++j)
  {
    const Eigen::Matrix3Xd motion = field.at(landmarks[static_cast<std::size_t>(j)]);
    for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
    {
      pulled(j, i) = -surface.normal(i).dot(motion.col(i));
    }
    if (!observer(static_cast<double>(j + 1) / static_cast<double>(total)))
    {
      return {};
    }
  }
  CouplingModes modes;
  modes.values.setZero(wanted, surface.pointTotal());
  if (total == 0)
  {
    return modes;
  }
  Eigen::MatrixXd between(total, total);
  for (Eigen::Index i = 0; i < total; ++i)
  {
    between.col(i) = pulled.col(landmarks[static_cast<std::size_t>(i)]);
  }
  const Eigen::MatrixXd symmetric = 0.5 * (between + between.transpose());
  // Eigenvalues in ascending order.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  const double least = ModeRounding * solver.eigenvalues().cwiseAbs().maxCoeff();
  for (Eigen::Index m = 0; m < std::min(wanted, total); ++m)
  {
    const double value = solver.eigenvalues()[total - 1 - m];
    if (!(value > least))
    {
      break;
    }
    Eigen::VectorXd vector = solver.eigenvectors().col(total - 1 - m);
    Eigen::Index largest = 0;
    vector.cwiseAbs().maxCoeff(&largest);
    vector *= vector[largest] < 0.0 ? -1.0 : 1.0;
    modes.values.row(m) = vector.transpose() * pulled / std::sqrt(value);
  }
  Eigen::MatrixXd there(wanted, total);
  for (Eigen::Index i = 0; i < total; ++i)
  {
    there.col(i) = modes.values.col(landmarks[static_cast<std::size_t>(i)]);
  }
  modes.neglected = neglectedBetween(symmetric, there);
  return modes;
}
} // namespace palpate
