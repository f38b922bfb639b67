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
 * (--measured, --register): "Response" for the first tool, then "Response2" ... The scene tells in
 * notes what each site was found to be; it is touched at the first site unless told where.
 * Returns an error, or "".
 */
std::string attachMeasured(const ViewerOptions& options, ViewerScene& scene);

/// What a curve of the scene's body is to be called besides its tool: ", from measured curves" or
/// ", from synthetic curves"; "" where nothing was measured.
std::string measuredLabel(const ViewerScene& scene);

/// Adds the readings of the first site, one curve per tool that measured it.
void addReadings(const ViewerScene& scene, vtkResponseChart* chart);
} // namespace palpate

#endif
