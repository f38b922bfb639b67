// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BendingError_h
#define palpate_BendingError_h

#include "Solids/FiniteElements/ElasticBody.h"

#include <functional>
#include <vector>

namespace palpate
{
/**
 * Fraction of a body's bending that its elements miss, measured at some of the sources for which
 * the body is solved. The fraction is x/(1 - x), where x is 4 e divided by the bending part of H.
 * Here e is the energy of the difference between the elements' stresses and smoothed ones
 * (energyErrors). At other places the weighted mean of the samples is used. The weight is the
 * bending at the sample divided by the square of the distance: a sample where the body hardly bends
 * has no information about bending. Near a crease or a held part the source's own field makes e up
 * to a hundred times larger. Samples above three times the weighted median of their neighbourhood
 * therefore do not count.
 *
 * The factor 4 is the one of complianceErrors(). BendingErrorTest and ShapedErrorTest check how
 * often the estimate holds.
 */
class BendingError
{
public:
  /// The value that is used without any measurement; the smallest and the largest value that are
  /// returned.
  static constexpr double Assumed = 0.1;
  static constexpr double Least = 0.005;
  static constexpr double Most = 0.5;

  /// A source: its place (mm), the bending part of H there and e, both mm/N.
  struct Sample
  {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double bending = 0.0;
    double energy = 0.0;
  };

  /// A block of solved sources.
  struct Choice
  {
    std::size_t block = 0;
    std::size_t blocks = 1;
    bool isCoarse = false; ///< whether only a quarter of the samples is used
  };

  /// Takes the samples of a block. Only some blocks are sampled, so that there are about two
  /// hundred samples in all. `sources`: surface points of the block. `smooth`: w at the unknowns,
  /// one column per source. `bendingOf`: bending part of H by index in `sources` (see Sample), NaN
  /// if unknown. Cost: 50 µs per element of the body.
  using BendingOf = std::function<double(std::size_t)>;
  static std::vector<Sample> sample(const ElasticBody& body, const Choice& choice,
    const std::vector<std::int32_t>& sources, const Eigen::MatrixXd& smooth,
    const BendingOf& bendingOf);

  explicit BendingError(std::vector<Sample> samples);

  double at(const Eigen::Vector3d& place) const;

private:
  /// Median of the samples around a place. `squares`: squared distances to all samples, at least
  /// one.
  double medianAround(const std::vector<double>& squares) const;

  std::vector<Sample> Samples;
};
} // namespace palpate

#endif
