// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/VerdictPanel.h"

#include "Comparison/RegimeColors.h"
#include "vtkContactTool.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace palpate
{
namespace
{
constexpr double PatchShare = 0.02; // width of the colour patch, as a fraction of the panel's width
constexpr int VerdictSize = 18;
constexpr int NumbersSize = 16;
constexpr int TermsSize = 14;
const char* const Terms =
  "lambda: share of the depth that is global; sensitivity: dlnF/dln(size of the tool)";

vtkSmartPointer<vtkTextActor> makeText(int size, double y)
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetTextProperty()->SetColor(TextColor.data());
  text->GetTextProperty()->SetFontSize(size);
  text->GetTextProperty()->SetLineSpacing(1.25);
  text->GetTextProperty()->SetVerticalJustificationToTop();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->GetPositionCoordinate()->SetValue(0.02, y);
  return text;
}
} // namespace

VerdictPanel::VerdictPanel()
  : Renderer(vtkSmartPointer<vtkRenderer>::New())
  , Patch(vtkSmartPointer<vtkRenderer>::New())
  , Verdict(makeText(VerdictSize, 0.92))
  , Numbers(makeText(NumbersSize, 0.67))
  , Explanation(makeText(TermsSize, 0.24))
{
  this->Verdict->GetTextProperty()->SetBold(1);
  this->Renderer->SetBackground(1.0, 1.0, 1.0);
  this->Renderer->InteractiveOff();
  this->Renderer->AddViewProp(this->Verdict);
  this->Renderer->AddViewProp(this->Numbers);
  this->Renderer->AddViewProp(this->Explanation);
  this->Explanation->GetTextProperty()->SetColor(0.40, 0.40, 0.43);
  this->Patch->SetBackground(1.0, 1.0, 1.0);
  this->Patch->InteractiveOff();
}

VerdictPanel::~VerdictPanel() = default;

void VerdictPanel::addTo(vtkRenderWindow* window, const double (&viewport)[4])
{
  const double split = viewport[0] + PatchShare * (viewport[2] - viewport[0]);
  this->Patch->SetViewport(viewport[0], viewport[1], split, viewport[3]);
  this->Renderer->SetViewport(split, viewport[1], viewport[2], viewport[3]);
  window->AddRenderer(this->Patch);
  window->AddRenderer(this->Renderer);
}

void VerdictPanel::show(const RegimeStatement& statement)
{
  const Color& color = VerdictColors[static_cast<std::size_t>(statement.verdict)];
  this->Patch->SetBackground(color[0], color[1], color[2]);
  this->Verdict->SetInput(verdictInWords(statement).c_str());
  this->Numbers->SetInput(numbersInWords(statement).c_str());
  this->Explanation->SetInput(Terms);
}
} // namespace palpate
