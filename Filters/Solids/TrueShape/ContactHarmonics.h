// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactHarmonics_h
#define palpate_ContactHarmonics_h

#include "Solids/TrueShape/ContactCurve.h"
#include "Solids/TrueShape/ContactKernels.h"

#include <cstddef>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// A curve during its construction: its samples, and the kernel and the stiffness of each sample.
struct CurveSamples
{
  std::vector<ContactSample> samples;
  std::vector<ContactKernel> kernels;
  std::vector<double> stiffness; ///< stiffness of each sample, N/mm
  /// Number of samples up to which the contact radius grows. It is constant for the later samples.
  std::size_t growing = 0;
};

/// Corrects the deflections of a curve's samples, to second order, for the parts of the shape that
/// the mean over angles omits (ShapedContact.h). If the second order is not sufficient and the
/// shape of the surface is known, the contact of `tool` with the surface is solved (UnevenContact).
/// Adds three errors to the samples: the residual of this correction; the effect of the surface
/// between its points; and the change of the compliance due to the direction of the force, which
/// follows the slope of the surface.
void addHarmonics(CurveSamples& curve, const ContactKernels& at, const AxisymmetricTool& tool);
} // namespace palpate

#endif
