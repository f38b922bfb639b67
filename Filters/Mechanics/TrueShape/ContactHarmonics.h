// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactHarmonics_h
#define palpate_ContactHarmonics_h

#include "Mechanics/TrueShape/ContactCurve.h"
#include "Mechanics/TrueShape/ContactKernels.h"

#include <cstddef>
#include <vector>

namespace palpate
{
class AxisymmetricTool;

/// Takes what the angle mean leaves out off the deflections of a curve's samples, to second order
/// (ShapedContact.h), or where that is not enough and the `surface` is known (not null) as `tool`
/// pressed on it solves it (UnevenContact). Adds to their errors what is left of it, and what the
/// surface between its points may do. `kernels`, `stiffness` (N/mm): beside the samples; the
/// contact of the first `growing` widens from one to the next, that of the others keeps its radius.
/// `modulus` is E*, MPa.
void addHarmonics(std::vector<ContactSample>& samples, std::size_t growing,
  const std::vector<ContactKernel>& kernels, const std::vector<double>& stiffness, double modulus,
  const AxisymmetricTool& tool, const SurfaceGap* surface);
} // namespace palpate

#endif
