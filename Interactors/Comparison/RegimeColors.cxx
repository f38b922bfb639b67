// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/RegimeColors.h"

#include "vtkColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkVariant.h"

namespace palpate
{
namespace
{
constexpr Color Unknown = { 0.62, 0.62, 0.64 };

// The colours are PuOr of ColorBrewer (Brewer and Harrower, colorbrewer2.org), with seven classes.
constexpr std::array<Color, 7> IndexColors = { { { 0.33, 0.15, 0.53 }, { 0.60, 0.56, 0.76 },
  { 0.85, 0.85, 0.92 }, { 0.97, 0.97, 0.97 }, { 1.00, 0.88, 0.71 }, { 0.95, 0.64, 0.25 },
  { 0.70, 0.35, 0.02 } } };

// The colours are Cividis (Nuñez, Anderton and Renslow 2018), from its light to its dark end.
constexpr std::array<Color, 5> SensitivityColors = { { { 0.995, 0.909, 0.217 },
  { 0.737, 0.683, 0.431 }, { 0.487, 0.482, 0.470 }, { 0.259, 0.306, 0.424 },
  { 0.000, 0.135, 0.305 } } };

/// Makes a colour map in which the colours are evenly spaced from `low` to `high`.
template <std::size_t Count>
vtkSmartPointer<vtkScalarsToColors> blend(
  const std::array<Color, Count>& colors, double low, double high)
{
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (std::size_t i = 0; i < Count; ++i)
  {
    const double at = low + (high - low) * static_cast<double>(i) / (Count - 1.0);
    function->AddRGBPoint(at, colors[i][0], colors[i][1], colors[i][2]);
  }
  function->SetNanColor(Unknown[0], Unknown[1], Unknown[2]);
  return function;
}
} // namespace

vtkSmartPointer<vtkScalarsToColors> makeIndexColors()
{
  return blend(IndexColors, -1.0, 1.0);
}

vtkSmartPointer<vtkScalarsToColors> makeSensitivityColors()
{
  return blend(SensitivityColors, 0.0, 1.5);
}

vtkSmartPointer<vtkScalarsToColors> makeVerdictColors()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(VerdictColors.size());
  table->SetTableRange(-0.5, VerdictColors.size() - 0.5);
  for (std::size_t i = 0; i < VerdictColors.size(); ++i)
  {
    const Color& color = VerdictColors[i];
    table->SetTableValue(static_cast<vtkIdType>(i), color[0], color[1], color[2]);
    table->SetAnnotation(vtkVariant(static_cast<double>(i)), VerdictNames[i]);
  }
  table->SetNanColor(Unknown[0], Unknown[1], Unknown[2], 1.0);
  return table;
}
} // namespace palpate
