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
/// A live session in a window. It consists of the window, the session on its servo thread, the
/// mouse that steers the session and, optionally, a panel and charts. If the mouse steers, a line
/// explains that the wheel presses; the line disappears when the wheel has been used. The caller
/// adds the actions for tools, keys and frames.
class HapticWindow
{
public:
  /// All objects that the arguments reference must outlive this object.
  HapticWindow(
    const ViewerOptions& options, const ViewerScene& scene, const ResponseSet& responses);

  /// Adds a panel on the right, which changes the setup, and charts at the bottom. Must be called
  /// before open().
  void usePanel(vtkContactSetup* setup);
  /// Shows lines of text at the top of the window. They replace the previous lines.
  void showHelp(const std::string& text);
  /// Shows the body with the tool above the first site of the scene, and prints this site.
  void open();
  /// Runs until the window is closed or a signal ends it. Then writes the last picture and the
  /// record if they are requested, and prints a summary. A record that was started by a key is also
  /// written. If the X server is lost, everything is done except the picture. Returns "" or an
  /// error.
  std::string run();

  /// Sets the action that is called when another tool is chosen in the panel. The action receives
  /// the index of the tool, from 0.
  void onTool(std::function<void(int)> action);
  /// Sets the actions for the keys 1 to 9 in a window without a panel, and for the space bar. The
  /// number of the key is passed as an index from 0.
  void onNumber(std::function<void(int)> action);
  void onSpace(std::function<void()> action);
  /// Sets the action that is called in each frame.
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
  double LargestForce; ///< largest force for the scale of arrows and charts, N
  std::vector<double> StrongestForces{
    0.0
  }; ///< largest ideal force in any frame, for each hand after the first one, N
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTextActor> Help;
  std::string HelpText;
  vtkNew<vtkTextActor> Hint; ///< explains how to press, above the help
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
  AtDisplayLoss ReleaseAtLoss{ [this] { return this->end(); } };
};
} // namespace palpate

#endif
