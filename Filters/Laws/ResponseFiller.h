// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ResponseFiller_h
#define palpate_ResponseFiller_h

#include "Laws/ContactSpot.h"
#include "Mechanics/PalpateExport.h"
#include "Laws/ValidityRule.h"

#include <cstddef>

namespace palpate
{
class AxisymmetricTool;
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
} // namespace palpate

#endif
