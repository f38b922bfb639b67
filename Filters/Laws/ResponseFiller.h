// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseFiller_h
#define palpate_ResponseFiller_h

#include "Laws/ContactSpot.h"
#include "Mechanics/PalpateExport.h"
#include "Laws/ValidityRule.h"

#include <cstddef>
#include <functional>

namespace palpate
{
class AxisymmetricTool;
class BodyMaterial;
class ResponseLaw;

/// Where the arrays of a response lie that is being made: per point one value, of force (N) and
/// stiffness (N/mm) `samples`.
struct ResponseSpans
{
  int samples;
  float* force;
  float* stiffness;
  float* range;    ///< mm
  float* validity; ///< mm
  unsigned char* status;
  unsigned char* limit;
};

/**
 * Fills the arrays of a response point by point: the curve of a law, and how deep it may be trusted
 * (ValidityRule.h). The status must be set: where it is not Valid the curve is zero.
 */
class PALPATE_EXPORT ResponseFiller
{
public:
  /// Tool, law and arrays must outlive this. `range` (mm) is the law's, `bodyWidth` (mm) that of
  /// the whole body.
  ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law, double range,
    double bodyWidth, const ResponseSpans& spans);

  /// Point `i`; different points may be filled at the same time. `curvature` (1/mm) as in
  /// ValidityRule; negative where no triangle with an area meets, which is Degenerate.
  void fill(std::size_t i, const ContactSpot& spot, double curvature) const;

private:
  unsigned char fillCurve(std::size_t i, const ContactSpot& spot, double curvature) const;

  const ResponseLaw& Law;
  ResponseSpans Spans;
  float Range;
  ValidityRule Rule;
};

/// What is to be known of a response besides its arrays.
struct MadeResponse
{
  bool complete = false;   ///< not given up on the way
  double exponent = 0.0;   ///< that stores it best
  std::size_t without = 0; ///< points whose status is not Valid
};

/// A tool pressed at each of `points` points of a body: fills the spans, whose status must be set.
/// `range` (mm): one that the tool's checkDepth allows. `curvature(i)` as in ResponseFiller; it may
/// be asked from several threads. `goOn(fraction)` is told how much is done, and stops it by false.
/// The same bits for any number of threads.
PALPATE_EXPORT MadeResponse response(const AxisymmetricTool& tool, const BodyMaterial& material,
  double range, double bodyWidth, std::size_t points,
  const std::function<double(std::size_t)>& curvature, const ResponseSpans& spans,
  const std::function<bool(double)>& goOn = {});
} // namespace palpate

#endif
