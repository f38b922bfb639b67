// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeasuredBody_h
#define palpate_MeasuredBody_h

#include "ViewerScene.h"

#include <string>

class vtkResponseChart;

namespace palpate
{
/**
 * Gives the body of a scene the responses of all its tools from the curves measured on it
 * (--measured, --register): "Response" for the first tool, then "Response2" ... The notes of the
 * scene list the result of each site; it is touched at the first site unless a place is given.
 * Returns an error, or "".
 */
std::string attachMeasured(const ViewerOptions& options, ViewerScene& scene);

/// The suffix of a curve's label after its tool: ", from measured curves" or ", from synthetic
/// curves"; "" if nothing was measured.
std::string measuredLabel(const ViewerScene& scene);

/// Adds the readings of the first site, one curve per tool that measured it.
void addReadings(const ViewerScene& scene, vtkResponseChart* chart);
} // namespace palpate

#endif
