// SPDX-License-Identifier: BSD-3-Clause
#ifndef PanelButton_h
#define PanelButton_h

#include "Interaction/Panel/PixelBox.h"

#include "vtkButtonRepresentation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTextActor.h"

#include <string>

namespace palpate
{
/// Draws a button of the panel and determines whether a position is on the button. The button is a
/// label in a box. The box is filled while the button is on.
class PanelButton : public vtkButtonRepresentation
{
public:
  static PanelButton* New() { VTK_STANDARD_NEW_BODY(PanelButton); }
  vtkTypeMacro(PanelButton, vtkButtonRepresentation);

  void setLabel(const std::string& label);
  const std::string& label() const { return this->Label; }
  void setOn(bool on);
  bool isOn() const { return this->On; }
  void alignLeft();

  /// Sets the position of the lower left corner and the size of the button, in pixels of the
  /// renderer.
  void place(double left, double bottom, double width, double height, int fontSize);
  /// Returns the centre of the button, in pixels of the renderer.
  void findMiddle(double position[2]) const;

  int ComputeInteractionState(int x, int y, int modify = 0) override;
  void Highlight(int state) override;
  void PlaceWidget(double*) override {}
  void BuildRepresentation() override {}
  void GetActors2D(vtkPropCollection* props) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  PanelButton();
  ~PanelButton() override = default;

private:
  PanelButton(const PanelButton&) = delete;
  void operator=(const PanelButton&) = delete;

  void recolor();
  template <class Do>
  void forEachActor(const Do& act);

  std::string Label;
  bool On = false;
  bool IsLeftAligned = false;
  PixelBox Box;
  vtkNew<vtkTextActor> Text;
};
} // namespace palpate

#endif
