// SPDX-License-Identifier: BSD-3-Clause
#ifndef RegimeColors_h
#define RegimeColors_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkSmartPointer.h"

#include <array>

class vtkScalarsToColors;

namespace palpate
{
/// Colours of the verdicts 0 to 2 of vtkContactRegime, after Okabe and Ito. A dark colour means
/// that the shape of the tool matters.
constexpr std::array<Color, 3> VerdictColors = { { { 0.00, 0.45, 0.70 }, { 0.90, 0.62, 0.00 },
  { 0.95, 0.90, 0.25 } } };

/// Short names of the verdicts, for a legend.
constexpr std::array<const char*, 3> VerdictNames = { "shape\nmatters", "mixed",
  "point force\nsuffices" };

// The colour maps of vtkRegimeMap. NaN is grey.
vtkSmartPointer<vtkScalarsToColors> makeIndexColors();
vtkSmartPointer<vtkScalarsToColors> makeSensitivityColors();
vtkSmartPointer<vtkScalarsToColors> makeVerdictColors();
} // namespace palpate

#endif
