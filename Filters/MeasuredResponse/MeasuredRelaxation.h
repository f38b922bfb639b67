// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeasuredRelaxation_h
#define MeasuredRelaxation_h

#include "MeasuredResponse/SiteMeasurement.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// Attaches the relaxation of the body to the response `name`. The relaxation times are common to
/// the sites used (CommonRelaxation.h). The strengths are the mean over these sites. If there are
/// several sites, the strengths at each point, interpolated between the sites, are also attached.
/// Attaches nothing if no site relaxes.
void attachMeasuredRelaxation(
  const SiteMeasurement& measurement, const std::string& name, vtkPolyData* output);

/// Describes the relaxation in words, as in the field array Model: strength and time of each
/// branch, and the times that the test resolves. Returns "" if no site relaxes.
std::string siteRelaxationInWords(const SiteMeasurement& measurement);
} // namespace palpate

#endif
