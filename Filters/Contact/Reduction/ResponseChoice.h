// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseChoice_h
#define palpate_ResponseChoice_h

#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseField.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// The forms of a response that can suffice for a body, from the simplest to the most general.
enum class ResponseNeed
{
  PointForce, ///< a spring per point, independent of the shape of the tool
  OneLaw,     ///< the same curve at every point
  ScaledLaw,  ///< one law, multiplied by a number per point
  FewLaws,    ///< a few laws, combined at each point
  PerVertex   ///< each point has its own curve
};

/// The permitted error of the forces, the fraction of the points that must satisfy it, and the
/// depth of the tool.
struct ChoiceSettings
{
  double tolerance = 0.01; ///< permitted relative error, > 0; see chooseResponse()
  double share = 1.0;      ///< fraction of the points that must be within the tolerance, 0 to 1
  double depth = 0.0;      ///< depth of the tool, mm; with 0, half of each point's range
  int mostLaws = 8;        ///< 1 to 16
};

/// Data of the points in addition to their curves. A null pointer means that the data are unknown.
struct ChoiceEvidence
{
  const std::uint8_t* verdict = nullptr; ///< RegimeVerdict of each point at `depth`
  const float* validity = nullptr;       ///< depth to which the law holds, mm
  /// The assumption that limits the validity (ResponseLimit), as in the data contract.
  const std::uint8_t* limit = nullptr;
};

/// Least and largest value of a quantity.
struct ChoiceSpread
{
  double least = 0.0;
  double most = 0.0;

  void add(double value, bool isFirst)
  {
    this->least = isFirst || value < this->least ? value : this->least;
    this->most = isFirst || value > this->most ? value : this->most;
  }
};

/**
 * The chosen form and the reasons for it. For all forms except PerVertex, the following arrays
 * replace the curves: `basis` has `laws` rows of n forces followed by n stiffnesses, and
 * `coefficient` has `laws` values per point (0 for points without response). PointForce has
 * `exponent` 1.
 */
struct ResponseChoice
{
  ResponseNeed need = ResponseNeed::PerVertex;
  int laws = 0;
  double exponent = 0.0;
  std::vector<float> basis;
  std::vector<float> coefficient;
  int numbersPerPoint = 0; ///< stored numbers per point, without normal, range and status

  std::size_t points = 0;  ///< points that have a response
  double keptShare = 1.0;  ///< fraction of these points within the tolerance
  double largestError = 0; ///< largest error over all these points

  bool regimeKnown = false;
  /// Fraction of the points at which the shape of the tool has no effect.
  double shapelessShare = 0.0;
  bool springTried = false; ///< whether springLoss and spring are set
  /// Largest error of one spring per point, divided by the force at the point's range.
  double springLoss = 0.0;
  ChoiceSpread spring; ///< N/mm
  ChoiceSpread range;  ///< mm
  ChoiceSpread depth;  ///< mm
  bool validityKnown = false;
  double beyondShare = 0.0; ///< fraction of the points at which `depth` exceeds the validity
  /// The assumption that breaks first at most of the points that are beyond the validity.
  int firstLimit = 0;
};

/**
 * Decides whether a body needs a separate response at each point, or a simpler form.
 *
 * A point force is chosen if three conditions hold at a fraction `share` of the points: the shape
 * of the tool has no effect (evidence.verdict is 2), the depth is within the validity of that law,
 * and the error of a spring F = k δ per point is within the tolerance. The stiffness k is the slope
 * of the secant to the end of the point's range, that is, the local compliance in series with the
 * global one. The error of a spring is relative to the force at the end of the range. It is not
 * relative to the force at the same depth, unlike the error of laws, because a spring cannot follow
 * the start of a contact: near δ = 0 its relative error is unbounded. If the local fraction at the
 * end of the range is ε = 1 - λ, the largest error of the spring of a sphere is ε/7 of the force at
 * the end, and occurs at 0.3 of the range.
 *
 * Otherwise the smallest number of laws is chosen for which a fraction `share` of the points is
 * within the tolerance of reduceResponse: |F' - F|/F at any depth up to the range. The laws are
 * computed from up to 8192 evenly spaced points, and are then tested on all points.
 *
 * The arrays may be in either form. Points without response (by status) are ignored. The result is
 * bit for bit the same for any number of threads. Cost: about 20 ns per point if all curves are the
 * same, else 2 to 3 µs per point on one core.
 */
PALPATE_EXPORT ResponseChoice chooseResponse(
  const ResponseArrays& arrays, const ChoiceEvidence& evidence, const ChoiceSettings& settings);
} // namespace palpate

#endif
