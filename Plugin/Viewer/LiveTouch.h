// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouch_h
#define palpate_LiveTouch_h

#include "ResponseSet.h"
#include "TouchScene.h"
#include "ViewerOptions.h"

#include "vtkContactScene.h"
#include "vtkHapticSession.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <functional>
#include <string>

namespace palpate
{
/// A body in a window under the hand: the window, the session on its servo thread, and the mouse
/// that steers it. What is being done with it is its owner's.
class LiveTouch
{
public:
  /// What all it is given refers to must outlive it.
  LiveTouch(const ViewerOptions& options, const TouchScene& scene, const ResponseSet& responses);

  /// A line at the top of the window.
  void showHelp(const std::string& text);
  /// Shows the body with the tool above the first site of the scene, and says so.
  void open();
  /// Until the window is closed. Then writes its last picture and the record, if asked to, and
  /// prints a summary. Returns an error, or "".
  std::string run();

  /// Draws the tool of these responses from now on.
  void chooseLook(std::size_t tool);
  /// What keys 1 to 9 do, told from 0; and the space bar.
  void onNumber(std::function<void(int)> action);
  void onSpace(std::function<void()> action);

  vtkHapticSession* session() { return this->Session; }
  vtkContactScene* view() { return this->View; }
  vtkInteractorStyleHaptic* style() { return this->Style; }
  void close() { this->Interactor->TerminateApp(); }

private:
  void printSummary();
  std::string writeRecord();

  const ViewerOptions& Options;
  const TouchScene& Scene;
  const ResponseSet& Responses;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkContactScene> View;
  vtkNew<vtkHapticSession> Session;
  vtkNew<vtkInteractorStyleHaptic> Style;
  std::function<void(int)> Number;
  std::function<void()> Space;
};

/// The largest stored force of any tool, N; 1 where the curves are stored in the compact form.
double largestForce(const ResponseSet& responses);
} // namespace palpate

#endif
