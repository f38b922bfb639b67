// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BendingError_h
#define palpate_BendingError_h

#include "Solids/FiniteElements/ElasticBody.h"

#include <functional>
#include <vector>

namespace palpate
{
/**
 * How much of a body's bending its elements miss, as a fraction, measured at some of the sources
 * that are solved anyway: x/(1 - x) with x = 4 e over the part of H that is bending, e the energy
 * that the elements' stresses lack of smooth ones (energyErrors). Elsewhere the mean of the
 * samples, each weighted by the inverse square of its distance and by how much the body bends
 * there: where it hardly bends, a sample tells nothing about bending. Next to a crease, or to what
 * is held, the source's own field makes up to a hundred times as much of e: samples beyond three
 * times the weighted median of those around do not count.
 *
 * The factor of 4 is that of complianceErrors(); how often it holds: BendingErrorTest,
 * ShapedErrorTest.
 */
class BendingError
{
public:
  /// What is assumed where nothing was measured; and what is told at least, and at most.
  static constexpr double Assumed = 0.1;
  static constexpr double Least = 0.005;
  static constexpr double Most = 0.5;

  /// A source: where it is, how much of H there is bending, and e, both mm/N.
  struct Sample
  {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double bending = 0.0;
    double energy = 0.0;
  };

  /// Samples of a block of solved sources: some of one block in so many that there are about two
  /// hundred in all. `sources`: their surface points; `smooth`: w by unknowns, a column each;
  /// `bendingOf` a place in them: see Sample, NaN where it is not known. Cost: 50 µs per element of
  /// the body.
  using BendingOf = std::function<double(std::size_t)>;
  static std::vector<Sample> sample(const ElasticBody& body, std::size_t block, std::size_t blocks,
    const std::vector<std::int32_t>& sources, const Eigen::MatrixXd& smooth,
    const BendingOf& bendingOf);

  explicit BendingError(std::vector<Sample> samples);

  double at(const Eigen::Vector3d& place) const;

private:
  /// `squares`: of the distances of all samples, at least one.
  double medianAround(const std::vector<double>& squares) const;

  std::vector<Sample> Samples;
};
} // namespace palpate

#endif
