// SPDX-License-Identifier: BSD-3-Clause
#ifndef PanelLook_h
#define PanelLook_h

#include "Interaction/Display/DisplayColors.h"

#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace palpate
{
constexpr Color PanelColor = { 0.92, 0.93, 0.94 };
constexpr Color PaperColor = { 1.00, 1.00, 1.00 };
constexpr Color HoverColor = { 0.86, 0.92, 0.96 };
constexpr Color OutlineColor = { 0.68, 0.70, 0.73 };
constexpr Color TrackColor = { 0.76, 0.78, 0.81 };
constexpr Color AccentColor = CurveColors[0];
constexpr Color HeadingColor = { 0.36, 0.38, 0.42 };

inline void stylePanelText(vtkTextActor* text, const Color& color)
{
  text->GetTextProperty()->SetColor(color[0], color[1], color[2]);
  text->GetTextProperty()->SetShadow(0);
}
} // namespace palpate

#endif
