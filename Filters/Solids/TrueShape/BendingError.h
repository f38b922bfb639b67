// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BendingError_h
#define palpate_BendingError_h

#include "Solids/FiniteElements/ElasticBody.h"

#include <functional>
#include <vector>

namespace palpate
{
/**
 * Fraction of a body's bending that its elements do not represent, sampled at some of the sources
 * for which the body is solved. The fraction is x/(1 - x), where x is 4 e divided by the bending
 * part of H. Here e is the energy of the difference between the elements' stresses and smoothed
 * stresses (energyErrors). At other positions, the weighted mean of the samples is used. The weight
 * is the bending at the sample divided by the square of the distance, because a sample where the
 * body hardly bends has no information about bending. Near a crease or a held part, the field of
 * the source itself makes e up to a hundred times larger. Therefore samples above three times the
 * weighted median of their neighbourhood are ignored.
 *
 * The factor 4 is that of complianceErrors(). BendingErrorTest and ShapedErrorTest check how often
 * the error is within the estimate.
 */
class BendingError
{
public:
  /// Value that is used without any sample, and smallest and largest value that is returned.
  static constexpr double Assumed = 0.1;
  static constexpr double Least = 0.005;
  static constexpr double Most = 0.5;

  /// A source: its position (mm), and the bending part of H and e at the position, both in mm/N.
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
    bool isCoarse = false; ///< whether only a quarter of the samples is taken
  };

  /// Takes the samples of a block. Only some blocks are sampled, so that there are about two
  /// hundred samples in total. `sources` contains the surface points of the block. `smooth`
  /// contains w at the unknowns, one column per source. `bendingOf` returns the bending part of H
  /// for an index in `sources` (see Sample), or NaN if it is unknown. Cost: 50 µs per element of
  /// the body.
  using BendingOf = std::function<double(std::size_t)>;
  static std::vector<Sample> sample(const ElasticBody& body, const Choice& choice,
    const std::vector<std::int32_t>& sources, const Eigen::MatrixXd& smooth,
    const BendingOf& bendingOf);

  explicit BendingError(std::vector<Sample> samples);

  double at(const Eigen::Vector3d& place) const;

private:
  /// Returns the median of the samples around a position. `squares` contains the squared distances
  /// to all samples, of which there is at least one.
  double medianAround(const std::vector<double>& squares) const;

  std::vector<Sample> Samples;
};
} // namespace palpate

#endif
