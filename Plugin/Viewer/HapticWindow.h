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
/// A live session in a window: the window, the session on its servo thread, and the mouse that
/// steers it; optionally a panel and charts. If the mouse steers, a line explains that the wheel
/// presses until it was used. Its owner decides its purpose.
class HapticWindow
{
public:
  /// Everything that the arguments reference must outlive it.
  HapticWindow(
    const ViewerOptions& options, const ViewerScene& scene, const ResponseSet& responses);

  /// Adds a panel on the right that changes the setup, and charts below. Before open().
  void usePanel(vtkContactSetup* setup);
  /// Shows lines at the top of the window, replacing the previous ones.
  void showHelp(const std::string& text);
  /// Shows the body with the tool above the first site of the scene, and prints it.
  void open();
  /// Runs until the window is closed, or a signal ends it. Then writes its last picture and the
  /// record, if requested, also one that was begun by key, and prints a summary. All but the
  /// picture is also done when the X server is lost. Returns an error, or "".
  std::string run();

  /// Sets the action when another tool was chosen in the panel, numbered from 0.
  void onTool(std::function<void(int)> action);
  /// Sets the action of keys 1 to 9, numbered from 0, without a panel; and of the space bar.
  void onNumber(std::function<void(int)> action);
  void onSpace(std::function<void()> action);
  /// Sets the action at each frame.
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
  double LargestForce;                        ///< for the scale of arrows and charts, N
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
