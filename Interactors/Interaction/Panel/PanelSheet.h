// SPDX-License-Identifier: BSD-3-Clause
#ifndef PanelSheet_h
#define PanelSheet_h

#include "Interaction/Panel/PanelButton.h"
#include "Interaction/Panel/PanelSlider.h"

#include "vtkButtonWidget.h"
#include "vtkNew.h"
#include "vtkSliderWidget.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"

#include <functional>
#include <list>
#include <string>
#include <vector>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace palpate
{
/// A column of headings, sliders and buttons in a renderer. The class does not depend on the
/// purpose of the controls.
class PanelSheet
{
public:
  using Action = std::function<void()>;

  PanelSheet();
  ~PanelSheet();
  PanelSheet(const PanelSheet&) = delete;
  PanelSheet& operator=(const PanelSheet&) = delete;

  void addHeading(const std::string& text);
  /// Adds a slider. `changed` is called when the handle moves, `released` when the mouse button is
  /// released.
  PanelSlider* addSlider(Action changed, Action released);
  /// Adds a button to a row of `inRow` buttons; call it `inRow` times for each row. The label of a
  /// single button is aligned left. Buttons that are added after the status are placed in the lower
  /// part of the status row, below one line of text. Therefore they move no other row when they
  /// appear.
  PanelButton* addButton(const std::string& label, Action pressed, int inRow = 1);
  void addStatus();
  void clear();

  /// Sets the text of the status. The text is broken into lines that fit into the sheet.
  void setStatus(const std::string& text) { this->StatusText = text; }
  const std::string& status() const { return this->StatusText; }

  void show(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor);
  void hide();
  bool isShown() const { return this->Renderer != nullptr; }
  /// Fits all rows to the present size of the renderer. Must be called before each frame.
  void place();

  const std::vector<vtkSmartPointer<PanelSlider>>& sliders() const { return this->Sliders; }
  const std::vector<vtkSmartPointer<PanelButton>>& buttons() const { return this->Buttons; }

private:
  /// A row of the sheet: a text, a slider or some buttons.
  struct Row
  {
    vtkSmartPointer<vtkTextActor> text;
    vtkSmartPointer<PanelSlider> slider;
    std::vector<vtkSmartPointer<PanelButton>> buttons;
    int columns = 1;
    double height = 0.0;

    bool isOnStatus = false; ///< placed in the lower part of the status row

    bool isShown() const;
    bool hasPlace() const { return this->isShown() && !this->isOnStatus; }
  };

  /// The status broken into lines, for one width (pixels) and one font size.
  struct BrokenText
  {
    std::string text;
    double width = 0.0;
    int fontSize = 0;
    std::string lines;
    double height = 0.0; ///< pixels
  };
  /// Breaks the status into lines, if `broken` is out of date.
  void breakStatus(double width, int fontSize, BrokenText& broken);
  void observe(vtkObject* object, unsigned long event, const Action& action);

  std::vector<Row> Rows;
  std::vector<vtkSmartPointer<PanelSlider>> Sliders;
  std::vector<vtkSmartPointer<PanelButton>> Buttons;
  std::vector<vtkSmartPointer<vtkAbstractWidget>> Widgets;
  vtkNew<vtkTextActor> Status;
  std::string StatusText;
  BrokenText FullSize;       ///< broken for a sheet with enough space
  BrokenText ShownSize;      ///< broken for the present size of the sheet
  std::list<Action> Actions; ///< referenced by the widgets
  vtkRenderer* Renderer = nullptr;
};
} // namespace palpate

#endif
