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
 * The validity of a law at a point: the depth at which its first assumption fails
 * (vtkToolContactResponse.h, Validity). Can be used from any number of threads.
 */
class PALPATE_EXPORT ValidityRule
{
public:
  /// The depth at which a law ends, and the reason.
  struct Answer
  {
    double depth;        ///< mm, at most the range
    ResponseLimit limit; ///< the assumption that fails at that depth; None at the range
  };

  /// `range` (mm) is the range of the law, `bodyWidth` (mm) the width of the whole body. Tool and
  /// law must outlive this object.
  ValidityRule(
    const AxisymmetricTool& tool, const ResponseLaw& law, double range, double bodyWidth);

  /// Returns the validity at a spot. `curvature` (1/mm) is the angle by which the body's normal
  /// changes per length of the surface at the point.
  Answer at(const ContactSpot& spot, double curvature) const;

private:
  const AxisymmetricTool& Tool;
  const ResponseLaw& Law;
  double Range;
  double StrainDepth;  ///< depth on a half-space at which the strain limit is reached, mm
  double StrainRadius; ///< contact radius at StrainDepth, mm
  double HalfWidth;    ///< half the width of the body, mm
  double WidthDepth;   ///< depth on a half-space at which the contact radius is HalfWidth, mm
};
} // namespace palpate

#endif
