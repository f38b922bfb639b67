// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/ColorLegend.h"

#include "vtkLookupTable.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <string>

namespace palpate
{
void fillColors(vtkLookupTable* table, const std::array<Color, 5>& colors)
{
  constexpr int size = 256;
  const double last = static_cast<double>(colors.size()) - 1.0;
  table->SetNumberOfTableValues(size);
  for (int i = 0; i < size; ++i)
  {
    const double position = last * i / (size - 1);
    const auto left = static_cast<std::size_t>(std::min(position, last - 1.0));
    const double share = position - static_cast<double>(left);
    Color color{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      color[k] = (1.0 - share) * colors[left][k] + share * colors[left + 1][k];
    }
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
}

void styleLegend(vtkScalarBarActor* legend, vtkLookupTable* table, const char* title, int fontSize)
{
  legend->SetLookupTable(table);
  legend->SetTitle((std::string(title) + "\n ").c_str()); // a line of air above the bar
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
