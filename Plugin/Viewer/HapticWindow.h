// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HapticWindow_h
#define palpate_HapticWindow_h

#include "DisplayServer.h"
#include "EndSignals.h"
#include "EventActions.h"
#include "ResponseSet.h"
#include "ViewerScene.h"
#include "ViewerOptions.h"

#include "vtkContactPanel.h"
#include "vtkContactScene.h"
#include "vtkContactSetup.h"
#include "vtkFrameClock.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkLiveCharts.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSessionFiles.h"
#include "vtkTextActor.h"

#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// A body in a window under the hand: the window, the session on its servo thread, and the mouse
/// that steers it; a panel and charts, if it is told to. Where the mouse is the hand, a line says
/// that the wheel presses until it has. What is being done with it is its owner's.
class HapticWindow
{
public:
  /// What all it is given refers to must outlive it.
  HapticWindow(
    const ViewerOptions& options, const ViewerScene& scene, const ResponseSet& responses);

  /// With a panel on the right that changes the setup, and charts below. Before open().
  void usePanel(vtkContactSetup* setup);
  /// Lines at the top of the window, in the place of those there were.
  void showHelp(const std::string& text);
  /// Shows the body with the tool above the first site of the scene, and says so.
  void open();
  /// Until the window is closed, or a signal asks for the end. Then writes its last picture and the
  /// record, if asked to, also one that was begun by key, and prints a summary. All but the picture
  /// is also done when the X server goes away. Returns an error, or "".
  std::string run();

  /// What is done when the panel has put another tool into the hand, told from 0.
  void onTool(std::function<void(int)> action);
  /// What keys 1 to 9 do, told from 0, where there is no panel; and the space bar.
  void onNumber(std::function<void(int)> action);
  void onSpace(std::function<void()> action);
  /// What is done at each frame.
  void onFrame(std::function<void()> action);

  vtkHapticSession* session() { return this->Session; }
  vtkContactScene* view() { return this->View; }
  vtkInteractorStyleHaptic* style() { return this->Style; }
  void close() { this->Interactor->TerminateApp(); }

private:
  void arrange();
  void placeHelp();
  std::string end();
  void printSummary();
  std::string writeRecords();

  const ViewerOptions& Options;
  const ViewerScene& Scene;
  const ResponseSet& Responses;
  double LargestForce;                        ///< that arrows and charts are scaled for, N
  std::vector<double> StrongestForces{ 0.0 }; ///< ideal force of the frames, of each hand, N
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTextActor> Help;
  std::string HelpText;
  vtkNew<vtkTextActor> Hint; ///< how to press, above the help
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkContactScene> View;
  vtkNew<vtkHapticSession> Session;
  vtkNew<vtkFrameClock> Clock;
  vtkNew<vtkSessionFiles> Files;
  vtkNew<vtkInteractorStyleHaptic> Style;
  vtkNew<vtkRenderer> PanelRenderer;
  vtkNew<vtkRenderer> ChartRenderer;
  vtkNew<vtkLiveCharts> Charts;
  vtkNew<vtkContactPanel> Panel;
  bool HasPanel = false;
  EventActions Actions;
  EndSignals Signals;
  AtDisplayLoss LetGo{ [this] { return this->end(); } };
};
} // namespace palpate

#endif
