// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/GlobalModes.h"

#include "Solids/FiniteElements/RegularField.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace palpate
{
namespace
{
std::size_t modeTotal(int count)
{
  return static_cast<std::size_t>(std::clamp(count, 0, MostGlobalModes));
}

/// Returns landmarks. The first is the valid point with the largest |C_g|. Each further landmark is
/// the valid point that is farthest from all landmarks chosen before.
std::vector<std::int32_t> spreadLandmarks(
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
  const auto size = [&](std::int32_t i)
  { return std::abs(compliances.compliance[static_cast<std::size_t>(i)]); };
  const auto first = std::max_element(
    valid.begin(), valid.end(), [&](std::int32_t a, std::int32_t b) { return size(a) < size(b); });
  return valid.empty() ? valid : spreadPoints(surface, valid, *first, wanted);
}

/// Returns the indices of the landmarks on each part of the body.
std::map<std::int32_t, std::vector<Eigen::Index>> landmarksByPart(
  const ElasticBody& body, const std::vector<std::int32_t>& landmarks)
{
  const std::vector<std::int32_t> part = partOfNodes(body.mesh());
  std::map<std::int32_t, std::vector<Eigen::Index>> found;
  for (std::size_t j = 0; j < landmarks.size(); ++j)
  {
    found[part[static_cast<std::size_t>(body.surface().node(landmarks[j]))]].push_back(
      static_cast<Eigen::Index>(j));
  }
  return found;
}

struct EigenPair
{
  double value = 0.0;
  Eigen::VectorXd vector;
};

/**
 * Returns the eigenpairs of the blocks of a symmetric matrix, in descending order of |value|. The
 * blocks are solved separately, because equal eigenvalues of two parts of the body would mix their
 * modes. The sign of each vector is chosen such that its entry of largest magnitude is positive.
 */
std::vector<EigenPair> eigenPairs(
  const Eigen::MatrixXd& matrix, const std::map<std::int32_t, std::vector<Eigen::Index>>& blocks)
{
  std::vector<EigenPair> pairs;
  for (const auto& [part, indices] : blocks)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix(indices, indices));
    for (Eigen::Index k = 0; k < solver.eigenvalues().size(); ++k)
    {
      Eigen::VectorXd vector = solver.eigenvectors().col(k);
      Eigen::Index largest = 0;
      vector.cwiseAbs().maxCoeff(&largest);
      vector *= vector[largest] < 0.0 ? -1.0 : 1.0;
      pairs.push_back({ solver.eigenvalues()[k], Eigen::VectorXd::Zero(matrix.rows()) });
      pairs.back().vector(indices) = vector;
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
    [](const EigenPair& a, const EigenPair& b) { return std::abs(a.value) > std::abs(b.value); });
  return pairs;
}

/// Returns Σ s (n·φ)² at a point.
double depth(const BodySurface& surface, const GlobalModes& modes, std::int32_t point)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < modes.fields.size(); ++k)
  {
    const double part = surface.normal(point).dot(modes.fields[k].col(point));
    sum += modes.signs[k] * part * part;
  }
  return sum;
}

double neglectedBy(
  const GlobalModes& modes, const BodySurface& surface, const PatchCompliances& compliances)
{
  double missing = 0.0;
  double whole = 0.0;
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    const double compliance = compliances.compliance[static_cast<std::size_t>(i)];
    if (compliances.status[static_cast<std::size_t>(i)] == PatchStatus::Valid)
    {
      missing += std::pow(compliance - depth(surface, modes, i), 2);
      whole += compliance * compliance;
    }
  }
  return whole > 0.0 ? std::sqrt(missing / whole) : 0.0;
}
} // namespace

std::vector<std::int32_t> spreadPoints(const BodySurface& surface,
  const std::vector<std::int32_t>& points, std::int32_t first, std::size_t wanted)
{
  std::vector<std::int32_t> chosen = { first };
  std::vector<double> away(points.size(), std::numeric_limits<double>::max());
  while (chosen.size() < std::min(wanted, points.size()))
  {
    std::size_t farthest = 0;
    for (std::size_t v = 0; v < points.size(); ++v)
    {
      away[v] = std::min(
        away[v], (surface.position(points[v]) - surface.position(chosen.back())).squaredNorm());
      farthest = away[v] > away[farthest] ? v : farthest;
    }
    if (away[farthest] == 0.0)
    {
      break; // the remaining points coincide with chosen points
    }
    chosen.push_back(points[farthest]);
  }
  chosen.resize(std::min(chosen.size(), wanted));
  return chosen;
}

GlobalModes modesOf(const ElasticBody& body, const std::vector<std::int32_t>& landmarks,
  const std::vector<Eigen::Matrix3Xd>& pulled, int count)
{
  const BodySurface& surface = body.surface();
  const std::size_t wanted = modeTotal(count);
  const auto total = static_cast<Eigen::Index>(landmarks.size());
  GlobalModes modes;
  modes.landmarks = landmarks;
  modes.fields.assign(wanted, Eigen::Matrix3Xd::Zero(3, surface.pointTotal()));
  modes.signs.assign(wanted, 1);

  Eigen::MatrixXd coupling(total, total);
  for (Eigen::Index i = 0; i < total; ++i)
  {
    const std::int32_t at = modes.landmarks[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < total; ++j)
    {
      coupling(i, j) = surface.normal(at).dot(pulled[static_cast<std::size_t>(j)].col(at));
    }
  }
  const Eigen::MatrixXd symmetric = 0.5 * (coupling + coupling.transpose());
  const double norm = symmetric.norm();
  modes.asymmetry = norm > 0.0 ? 0.5 * (coupling - coupling.transpose()).norm() / norm : 0.0;
  const std::vector<EigenPair> pairs =
    eigenPairs(symmetric, landmarksByPart(body, modes.landmarks));
  for (std::size_t k = 0; k < std::min(wanted, pairs.size()); ++k)
  {
    const auto& [value, vector] = pairs[k];
    if (!(std::abs(value) > ModeRounding * std::abs(pairs[0].value)))
    {
      break;
    }
    for (Eigen::Index j = 0; j < total; ++j)
    {
      modes.fields[k] +=
        vector[j] / std::sqrt(std::abs(value)) * pulled[static_cast<std::size_t>(j)];
    }
    modes.signs[k] = value < 0.0 ? -1 : 1;
  }
  return modes;
}

GlobalModes globalModes(const ElasticBody& body, const PatchCompliances& compliances, double radius,
  int count, const WorkObserver& observer)
{
  const BodySurface& surface = body.surface();
  const std::vector<std::int32_t> landmarks =
    spreadLandmarks(surface, compliances, modeTotal(count) * LandmarksPerMode);
  std::vector<Eigen::Matrix3Xd> pulled; // fields g_j, one per landmark
  const RegularField field(body, radius);
  const auto total = static_cast<double>(landmarks.size());
  for (std::size_t j = 0; j < landmarks.size(); ++j)
  {
    pulled.emplace_back(-field.at(landmarks[j]));
    if (!observer(static_cast<double>(j + 1) / total))
    {
      return {};
    }
  }
  GlobalModes modes = modesOf(body, landmarks, pulled, count);
  modes.neglected = neglectedBy(modes, surface, compliances);
  return modes;
}
} // namespace palpate
