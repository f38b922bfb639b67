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
/// The simplest form that a body's response needs; the simplest first.
enum class ResponseNeed
{
  PointForce, ///< a spring per point, whatever the shape of the tool
  OneLaw,     ///< the same curve at every point
  ScaledLaw,  ///< one law, times a number per point
  FewLaws,    ///< a few laws, combined at each point
  PerVertex   ///< each point has its own curve
};

/// How much a form may change the forces, at how many points, and how deep.
struct ChoiceSettings
{
  double tolerance = 0.01; ///< see chooseResponse; > 0
  double share = 1.0;      ///< fraction of the points that must keep it, 0 to 1
  double depth = 0.0;      ///< depth of the tool, mm; 0: half of each point's range
  int mostLaws = 8;        ///< 1 to 16
};

/// Data of the points in addition to their curves; null: unknown.
struct ChoiceEvidence
{
  const std::uint8_t* verdict = nullptr; ///< RegimeVerdict at `depth`
  const float* validity = nullptr;       ///< depth to which the law holds, mm
  const std::uint8_t* limit = nullptr;   ///< assumption that breaks there, as in the data contract
};

/// The range of a quantity.
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
 * The choice and its basis. Unless PerVertex, these arrays replace the curves: `basis` has `laws`
 * rows of n forces then n stiffnesses, and `coefficient` has `laws` values per point (0 without
 * response). PointForce has `exponent` 1.
 */
struct ResponseChoice
{
  ResponseNeed need = ResponseNeed::PerVertex;
  int laws = 0;
  double exponent = 0.0;
  std::vector<float> basis;
  std::vector<float> coefficient;
  int numbersPerPoint = 0; ///< stored, without normal, range and status

  std::size_t points = 0;  ///< points that have a response
  double keptShare = 1.0;  ///< fraction of them within the tolerance
  double largestError = 0; ///< over all of them

  bool regimeKnown = false;
  double shapelessShare = 0.0; ///< fraction of the points where the tool's shape does not matter
  bool springTried = false;    ///< true: the next two are set
  double springLoss = 0.0;     ///< largest error of a spring per point, over the force at its range
  ChoiceSpread spring;         ///< N/mm
  ChoiceSpread range;          ///< mm
  ChoiceSpread depth;          ///< mm
  bool validityKnown = false;
  double beyondShare = 0.0; ///< fraction of the points where `depth` is beyond validity
  int firstLimit = 0;       ///< the assumption that breaks there at most points
};

/**
 * Decides whether a body needs a response per point, or less.
 *
 * A point force is chosen under three conditions at a fraction `share` of the points. The shape of
 * the tool does not matter (evidence.verdict is 2), the depth is within the validity of that law,
 * and the error of a spring F = k δ per point is within the tolerance. That error is relative to
 * the force at the end of the point's range. k is the secant there: the local compliance in series
 * with the global one. The error is not relative to the force at its own depth, as it is below,
 * because a spring cannot follow the start of a contact: near δ = 0 its relative error is
 * unbounded. With the local fraction ε = 1 - λ at the end of the range, the error of a sphere's
 * spring is ε/7 of the force there, at 0.3 of the range.
 *
 * Otherwise the fewest laws are chosen with which a fraction `share` of the points is within the
 * tolerance of reduceResponse: |F' - F|/F at any depth up to the range. The laws come from up to
 * 8192 points, evenly spaced, and are then tested on all points.
 *
 * Arrays in either form; points without response (by status) are ignored. The same bits for any
 * number of threads. Cost: some 20 ns per point if all curves are the same, else 2 to 3 us per
 * point and core.
 */
PALPATE_EXPORT ResponseChoice chooseResponse(
  const ResponseArrays& arrays, const ChoiceEvidence& evidence, const ChoiceSettings& settings);
} // namespace palpate

#endif
