// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactPanel
 * @brief sliders and buttons for tool, material, contact and display during contact
 *
 * Fills its own renderer, a strip of the window, with controls for: the tools and the size of the
 * chosen one, Young's modulus, Poisson's ratio, friction, the model of the body, the exaggeration
 * of the dent, the comparison of tools, the charts, the session, records and pictures. The panel is
 * a live version of figure 9 of Mahvash and Hayward (2002). The controls are vtkSliderWidgets and
 * vtkButtonWidgets.
 *
 * Before the call of On, set a renderer of a window with an interactor, a setup, a style with
 * session, scene and files, a clock and, optionally, charts. At each frame of the clock, the panel
 * requests new responses from the setup if a setting was changed by the panel or by a program. It
 * passes finished responses to session, scene and charts, and shows the present settings. The
 * window never waits for responses: the old responses are used and shown until the new ones are
 * ready.
 *
 * All functions of the panel are also available without the panel, as methods of vtkContactSetup
 * (tool, size, material, model), vtkHapticSession (friction, start and stop), vtkContactScene
 * (exaggeration), vtkLiveCharts (comparison), vtkSessionFiles (record, picture) and
 * vtkInteractorStyleHaptic (help). Controls that the body or the setup does not support are
 * omitted. With Model Stored only the display can be changed.
 *
 * @code{.py}
 * panel = palpate.vtkContactPanel()
 * panel.SetRenderer(strip)                             # of a window with an interactor
 * panel.SetSetup(setup)
 * panel.SetStyle(style)
 * panel.SetClock(clock)
 * panel.On()
 * @endcode
 */
#ifndef vtkContactPanel_h
#define vtkContactPanel_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkContactSetup;
class vtkFrameClock;
class vtkInteractorStyleHaptic;
class vtkLiveCharts;
class vtkRenderer;

class PALPATEINTERACTION_EXPORT vtkContactPanel : public vtkObject
{
public:
  static vtkContactPanel* New();
  vtkTypeMacro(vtkContactPanel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    ToolShownEvent = 1501 ///< another tool was chosen
  };

  /**
   * The renderer of the strip. The panel sets its background, but not its camera. The strip should
   * be about 256 pixels wide and 700 pixels high. In a smaller strip the panel is reduced in size.
   */
  void SetRenderer(vtkRenderer* renderer);
  /** The setup. Call Update of the setup before On, because the panel needs its output. */
  void SetSetup(vtkContactSetup* setup);
  /** The interactor style. It must have session, scene and interactor. The buttons Record and
   * Picture also need its files. */
  void SetStyle(vtkInteractorStyleHaptic* style);
  /** The clock. The panel is updated at each frame of the clock. Without a clock, the program must
   * call Update. */
  void SetClock(vtkFrameClock* clock);
  /** The charts (optional). The controls Compare, Charts and Timing need them. */
  void SetCharts(vtkLiveCharts* charts);

  ///@{
  /** Shows or hides the panel. The panel receives mouse events only while it is shown. */
  void On();
  void Off();
  ///@}

  /** Does the work of one frame (see the description of the class). */
  void Update();

  /**
   * Makes the tool with the index `tool` of the setup (from 0) the tool of session, scene and
   * charts. No effect if there is no such tool.
   */
  void ChooseTool(int tool);

  ///@{
  /** Whether the charts compare all tools at the contact, instead of showing the curves of the
   * triangle's three corners. Default off. The key c toggles it. */
  void SetCompare(bool compare);
  bool GetCompare();
  ///@}
  ///@{
  /** Whether the charts are shown. Default on. The key g toggles it. */
  void SetChartsVisibility(bool visible);
  bool GetChartsVisibility();
  ///@}

  ///@{
  /**
   * Returns the position of a control in the window, in pixels from the lower left corner.
   * FindButton finds the button with this label. FindHandle finds the handle of the slider with
   * this name at `value` (mm, degrees, MPa or 1). Both return false if there is no such control.
   * For tests and demonstrations.
   */
  bool FindButton(const std::string& label, int position[2]);
  bool FindSlider(const std::string& name, double value, int position[2]);
  ///@}
  /** Returns the last line of the panel: a text about the work in progress, or the error. */
  std::string GetStatus();

protected:
  vtkContactPanel();
  ~vtkContactPanel() override;

private:
  vtkContactPanel(const vtkContactPanel&) = delete;
  void operator=(const vtkContactPanel&) = delete;

  void MakeControls();
  void ShowValues();

  struct Parts;
  std::unique_ptr<Parts> Kept;
};

#endif
