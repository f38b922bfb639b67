// SPDX-License-Identifier: BSD-3-Clause
#ifndef PanelSlider_h
#define PanelSlider_h

#include "Interaction/Panel/PanelScale.h"
#include "Interaction/Panel/PixelBox.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSliderRepresentation.h"
#include "vtkTextActor.h"

#include <functional>
#include <string>

namespace palpate
{
/// Draws a slider of the panel and determines whether a position is on the slider. Name and value
/// are above the track. If the mouse button is pressed anywhere on the row, the handle moves to
/// that position. The handle then follows the mouse until the button is released.
class PanelSlider : public vtkSliderRepresentation
{
public:
  static PanelSlider* New() { VTK_STANDARD_NEW_BODY(PanelSlider); }
  vtkTypeMacro(PanelSlider, vtkSliderRepresentation);

  /// Returns a value as text with its unit.
  using Format = std::function<std::string(double)>;
  void setMeaning(const std::string& name, const PanelScale& scale, Format format);
  const std::string& name() const { return this->Title; }

  void setQuantity(double value);
  double quantity() const { return this->Scale.valueAt(this->Share); }
  bool isHeld() const { return this->Held; }
  void release() { this->Held = false; }

  /// Sets the position of the lower left corner and the size of the row, in pixels of the renderer.
  void place(double left, double bottom, double width, double height, int fontSize);
  /// Returns the position of the handle for a value, in pixels of the renderer.
  void findHandle(double value, double position[2]) const;

  void SetTitleText(const char* title) override { this->Title = title ? title : ""; }
  const char* GetTitleText() override { return this->Title.c_str(); }
  void StartWidgetInteraction(double position[2]) override;
  void WidgetInteraction(double position[2]) override;
  void Highlight(int) override {}
  void BuildRepresentation() override {}
  void GetActors2D(vtkPropCollection* props) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  PanelSlider();
  ~PanelSlider() override = default;

private:
  PanelSlider(const PanelSlider&) = delete;
  void operator=(const PanelSlider&) = delete;

  void follow(const double position[2]);
  void show();
  template <class Do>
  void forEachActor(const Do& act);

  std::string Title;
  PanelScale Scale;
  Format Write;
  double Share = 0.0;
  bool Held = false;
  PixelBox Row; ///< area of the row; it is not drawn
  PixelBox Track;
  PixelBox Filled;
  PixelBox Handle;
  vtkNew<vtkTextActor> Name;
  vtkNew<vtkTextActor> ValueText;
};
} // namespace palpate

#endif
