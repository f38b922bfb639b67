// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactPanel
 * @brief sliders and buttons for what is touched, how, and how it is shown, while it is felt
 *
 * Fills a renderer, a strip of the window of its own, with the tools and the size of the one in the
 * hand, Young's modulus, Poisson's ratio, friction, the model of the body, how deep the dent is
 * drawn, whether tools are compared, charts, the session, record and picture. (Mahvash and Hayward
 * 2002, figure 9, live.) Made of vtkSliderWidget and vtkButtonWidget.
 *
 * Give it a renderer of a window with an interactor, a setup, and the style that has session, scene
 * and files; the clock, and charts if there are any. Then On. At each frame of the clock it asks
 * the setup for new responses when something has been changed, by the panel or by a program, hands
 * those that are ready to session, scene and charts, and shows how everything is set now. The
 * window never waits for responses: until they are there the old ones are felt and shown.
 *
 * All that it does can be done without it: by methods of vtkContactSetup (tool, size, material,
 * model), vtkHapticSession (friction, start and stop), vtkContactScene (exaggeration),
 * vtkLiveCharts (comparison), vtkSessionFiles (record, picture) and vtkInteractorStyleHaptic
 * (help). What the body or the setup cannot have is not offered; with Model Stored only what is
 * shown can be changed.
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
    ToolShownEvent = 1501 ///< another tool is in the hand
  };

  /** The strip; the panel sets its background and takes it out of the camera's hands. About 256
   * pixels wide and 700 high; it shrinks with less. */
  void SetRenderer(vtkRenderer* renderer);
  /** What is touched. Its output must be there: call its Update before On. */
  void SetSetup(vtkContactSetup* setup);
  /** Who has session, scene and interactor; and files, for Record and Picture. */
  void SetStyle(vtkInteractorStyleHaptic* style);
  /** Whose frames it follows; without, call Update. */
  void SetClock(vtkFrameClock* clock);
  /** Optional: what Compare, Charts and Timing change. */
  void SetCharts(vtkLiveCharts* charts);

  ///@{
  /** Shows the panel and listens to the mouse, or no longer. */
  void On();
  void Off();
  ///@}

  /** What happens once a frame, see above. */
  void Update();

  /** Puts a tool of the setup, from 0, into the hand: in session, scene and charts. Nothing happens
   * if there is none. */
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
   * Where in the window, in pixels from its lower left corner, the button of this label is, or the
   * handle of the slider of this name when it says `value` (mm, degrees, MPa, 1). False if there is
   * none. For tests, and scripts that demonstrate.
   */
  bool FindButton(const std::string& label, int position[2]);
  bool FindSlider(const std::string& name, double value, int position[2]);
  ///@}
  /** The last line of the panel: what is under way, or what went wrong. */
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
