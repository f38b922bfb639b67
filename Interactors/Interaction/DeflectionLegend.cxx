// SPDX-License-Identifier: BSD-3-Clause
#include "DeflectionLegend.h"

#include "DisplayColors.h"

#include "vtkLookupTable.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>

namespace palpate
{
void fillDeflectionColors(vtkLookupTable* table)
{
  constexpr int size = 256;
  constexpr double last = DeflectionColors.size() - 1;
  table->SetNumberOfTableValues(size);
  for (int i = 0; i < size; ++i)
  {
    const double position = last * i / (size - 1);
    const auto left = static_cast<std::size_t>(std::min(position, last - 1.0));
    const double share = position - static_cast<double>(left);
    Color color{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      color[k] = (1.0 - share) * DeflectionColors[left][k] + share * DeflectionColors[left + 1][k];
    }
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  table->SetVectorModeToMagnitude();
}

void styleDeflectionLegend(vtkScalarBarActor* legend, vtkLookupTable* colors, int fontSize)
{
  legend->SetLookupTable(colors);
  legend->SetTitle("Displacement (mm)\n ");
  legend->SetNumberOfLabels(5);
  legend->SetLabelFormat("%.2f");
  legend->SetBarRatio(0.25);
  legend->UnconstrainedFontSizeOn();
  legend->SetHeight(0.5);
  for (vtkTextProperty* text : { legend->GetTitleTextProperty(), legend->GetLabelTextProperty() })
  {
    text->SetColor(TextColor.data());
    text->SetFontSize(fontSize);
    text->SetBold(0);
    text->SetItalic(0);
    text->SetShadow(0);
  }
}
} // namespace palpate
