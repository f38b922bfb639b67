// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactPanel
 * @brief sliders and buttons for tool, material, contact and display during contact
 *
 * Fills its own renderer, a strip of the window, with the tools and the size of the chosen one,
 * Young's modulus, Poisson's ratio, friction, the model of the body, exaggeration of the dent,
 * comparison of tools, charts, the session, record and picture. (Mahvash and Hayward 2002, figure
 * 9, live.) Made of vtkSliderWidget and vtkButtonWidget.
 *
 * Give it a renderer of a window with an interactor, a setup, and the style that has session, scene
 * and files; the clock, and charts if there are any. Then On. At each frame of the clock it
 * requests new responses from the setup if something was changed, by the panel or by a program,
 * passes those that are ready to session, scene and charts, and shows the present settings. The
 * window never waits for responses: until they are ready the old ones are felt and shown.
 *
 * All its functions are available without it: by methods of vtkContactSetup (tool, size, material,
 * model), vtkHapticSession (friction, start and stop), vtkContactScene (exaggeration),
 * vtkLiveCharts (comparison), vtkSessionFiles (record, picture) and vtkInteractorStyleHaptic
 * (help). Controls that the body or the setup does not support are left out; with Model Stored only
 * the display can be changed.
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
   * The strip; the panel sets its background, and the camera is not controlled there. About 256
   * pixels wide and 700 high; it shrinks with less.
   */
  void SetRenderer(vtkRenderer* renderer);
  /** The setup. Its output must exist: call its Update before On. */
  void SetSetup(vtkContactSetup* setup);
  /** The style, with session, scene and interactor; and files, for Record and Picture. */
  void SetStyle(vtkInteractorStyleHaptic* style);
  /** The clock whose frames it follows; without one, call Update. */
  void SetClock(vtkFrameClock* clock);
  /** Optional: the charts, for Compare, Charts and Timing. */
  void SetCharts(vtkLiveCharts* charts);

  ///@{
  /** Shows or hides the panel, and starts or stops listening to the mouse. */
  void On();
  void Off();
  ///@}

  /** The work of a frame, see above. */
  void Update();

  /**
   * Chooses a tool of the setup, from 0, in session, scene and charts. Nothing happens if there is
   * none.
   */
  void ChooseTool(int tool);

  ///@{
  /** Whether the charts compare all tools at the contact, instead of showing the three curves of
   * the triangle. Default off. Key c. */
  void SetCompare(bool compare);
  bool GetCompare();
  ///@}
  ///@{
  /** Whether there are charts. Default on. Key g. */
  void SetChartsVisibility(bool visible);
  bool GetChartsVisibility();
  ///@}

  ///@{
  /**
   * Position in the window, in pixels from its lower left corner, of the button of this label, or
   * of the handle of the slider of this name at `value` (mm, degrees, MPa, 1). False if there is
   * none. For tests and demonstrations.
   */
  bool FindButton(const std::string& label, int position[2]);
  bool FindSlider(const std::string& name, double value, int position[2]);
  ///@}
  /** The last line of the panel: what is being computed, or what went wrong. */
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
