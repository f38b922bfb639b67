// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ValidityRule_h
#define palpate_ValidityRule_h

#include "Laws/ContactSpot.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/ResponseContract.h"

namespace palpate
{
class AxisymmetricTool;
class ResponseLaw;

/**
 * How deep a law may be trusted at a point: the depth at which its first assumption breaks
 * (vtkToolContactResponse.h, Validity). Safe to use from any number of threads.
 */
class PALPATE_EXPORT ValidityRule
{
public:
  /// Where a law is left, and by what.
  struct Answer
  {
    double depth;        ///< mm, at most the range
    ResponseLimit limit; ///< what breaks there; None at the range
  };

  /// Tool and law must outlive this. `range` (mm) is the law's, `bodyWidth` (mm) that of the whole
  /// body.
  ValidityRule(
    const AxisymmetricTool& tool, const ResponseLaw& law, double range, double bodyWidth);

  /// `curvature` (1/mm): how fast the body's normal turns at the point.
  Answer at(const ContactSpot& spot, double curvature) const;

private:
  const AxisymmetricTool& Tool;
  const ResponseLaw& Law;
  double Range;
  double StrainDepth;  ///< on a half-space
  double StrainRadius; ///< the contact radius there
  double HalfWidth;    ///< of the body
  double WidthDepth;   ///< on a half-space, where the contact radius is as large
};
} // namespace palpate

#endif
