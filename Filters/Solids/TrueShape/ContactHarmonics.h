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

/// A curve on its way: its samples, and beside each of them what it was made of.
struct CurveSamples
{
  std::vector<ContactSample> samples;
  std::vector<ContactKernel> kernels;
  std::vector<double> stiffness; ///< N/mm
  /// The contact of the first so many widens from one to the next, that of the others keeps its
  /// radius.
  std::size_t growing = 0;
};

/// Takes what the angle mean leaves out off the deflections of a curve's samples, to second order
/// (ShapedContact.h), or where that is not enough and the surface is known as `tool` pressed on it
/// solves it (UnevenContact). Adds to their errors what is left of it; what the surface between its
/// points may do; and, as the force leans with the surface, how the body yields otherwise in that
/// direction than along the normal.
void addHarmonics(CurveSamples& curve, const ContactKernels& at, const AxisymmetricTool& tool);
} // namespace palpate

#endif
