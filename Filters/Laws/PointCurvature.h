// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PointCurvature_h
#define palpate_PointCurvature_h

#include "Laws/PointForm.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
/// The two principal curvatures at a point, and the error of their mean, 1/mm.
using PointCurvature = std::array<float, 3>;

// Variances of the averages along each axis. ContactVariance is that of the area over which a
// contact averages, in squared contact radii. The other variances are in squared distances of
// points. On a triangular lattice with edges e, for a wave with the wavenumber k, the curvature by
// sags is too small by (k e)²/12, and the curvature by turns by (k e)²/4 (see PointForm).
inline constexpr double ContactVariance = 0.1;
inline constexpr double SagVariance = 0.192;
inline constexpr double TurnVariance = 0.577;
inline constexpr double StepVariance = 0.5;
// Squared edge length of the lattice, in squared distances of points.
inline constexpr double EdgeSquare = 1.155;
/// The largest weight of the curvature by sags, used for contacts smaller than the facets.
inline constexpr double LargestSagWeight = 1.5;
// Factors for errors that are estimated from a few neighbours. The results bound 95 of 100 errors;
// see SurfaceCurvatureTest.cxx. PointFactor is the factor on roughness, residual and difference at
// one point.
inline constexpr double PointFactor = 0.7;
inline constexpr double NoisyPointFactor = 2.5; // factor for one point if the surface is noisy

/// Returns the eigenvalues of a second fundamental form, and the error of their mean.
inline PointCurvature principal(const Eigen::Vector3d& form, double error)
{
  const double mean = 0.5 * (form[0] + form[2]);
  const double half = std::hypot(0.5 * (form[0] - form[2]), form[1]);
  return { static_cast<float>(mean - half), static_cast<float>(mean + half),
    static_cast<float>(error) };
}

/// Returns the curvature for a contact that is not wider than the area over which the turns
/// average. `noise` is the fraction of noise in the surface, 0 to 1.
inline PointCurvature pointCurvature(
  const PointForm& fit, double roughness, double contactRadius, double noise)
{
  const double wanted = fit.edgeSquare > 0.0
    ? ContactVariance * contactRadius * contactRadius * EdgeSquare / fit.edgeSquare
    : 0.0;
  const double finer = (1.0 - noise) *
    std::clamp((TurnVariance - wanted) / (TurnVariance - SagVariance), 0.0, LargestSagWeight);
  const double smooth =
    PointFactor * Eigen::Vector3d(roughness, fit.residual, (1.0 - noise) * fit.difference()).norm();
  const double noisy = std::max(fit.residual, NoisyPointFactor * roughness);
  return principal(
    fit.byTurns + finer * (fit.bySags - fit.byTurns), noise * noisy + (1.0 - noise) * smooth);
}
} // namespace palpate

#endif
