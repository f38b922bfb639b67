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

/// A curve under construction: its samples, and the kernel and the stiffness of each.
struct CurveSamples
{
  std::vector<ContactSample> samples;
  std::vector<ContactKernel> kernels;
  std::vector<double> stiffness; ///< N/mm
  /// Number of samples, from the first, with a growing contact radius. The others keep their
  /// radius.
  std::size_t growing = 0;
};

/// Corrects the deflections of a curve's samples for the parts that the angle mean leaves out, to
/// second order (ShapedContact.h). If that is not enough and the surface is known, the contact of
/// `tool` with the surface is solved (UnevenContact). Adds three errors to the samples: the
/// residual of this correction, the effect of the surface between its points, and the different
/// compliance in the direction of the force, which leans with the surface.
void addHarmonics(CurveSamples& curve, const ContactKernels& at, const AxisymmetricTool& tool);
} // namespace palpate

#endif
