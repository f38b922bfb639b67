// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeasuredRelaxation_h
#define MeasuredRelaxation_h

#include "MeasuredResponse/SiteMeasurement.h"

#include <string>

class vtkPolyData;

namespace palpate
{
/// Attaches to the response `name` how its body relaxes: times common to the used sites
/// (CommonRelaxation.h), the mean of their strengths, and, with several sites, the strengths at
/// each point between them. Nothing where no site relaxes.
void attachMeasuredRelaxation(
  const SiteMeasurement& measurement, const std::string& name, vtkPolyData* output);

/// ", relaxing 0.5 in 0.1 s, 0.3 in 2 s (told from 0.003 to 10 s)": as the field array Model says
/// it; "" where no site relaxes.
std::string siteRelaxationInWords(const SiteMeasurement& measurement);
} // namespace palpate

#endif
