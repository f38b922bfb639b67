// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFrameClock
 * @brief notifies observers of each frame, then draws the frame
 *
 * Set an interactor and call Start. A repeating timer of the interactor makes up to 30 frames per
 * second. Each frame invokes FrameEvent and then renders. Scene, charts and panel update themselves
 * on FrameEvent. Changes by mouse, wheel and widgets are drawn with the next frame, so that no
 * event waits for a rendering. If the frames are slow, at least half of the time remains for mouse
 * events.
 *
 * Observers with a higher priority are called first: vtkContactPanel, which changes the scene, has
 * priority 1; vtkContactScene has -1.
 *
 * @code{.py}
 * clock = palpate.vtkFrameClock()
 * clock.SetInteractor(interactor)
 * scene.Follow(clock, session)
 * clock.AddObserver(clock.FrameEvent, lambda *_: charts.Update())
 * clock.Start()                                        # up to 30 frames per second
 * @endcode
 */
#ifndef vtkFrameClock_h
#define vtkFrameClock_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For vtkCommand::UserEvent
#include "vtkObject.h"
#include "vtkWeakPointer.h" // For vtkWeakPointer

#include <chrono> // For std::chrono::steady_clock

class vtkRenderWindowInteractor;

class PALPATEINTERACTION_EXPORT vtkFrameClock : public vtkObject
{
public:
  static vtkFrameClock* New();
  vtkTypeMacro(vtkFrameClock, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    FrameEvent = vtkCommand::UserEvent + 411 ///< invoked before a frame is drawn
  };

  ///@{
  /** The interactor, which has the timer and the window. It must be initialised before Start. */
  void SetInteractor(vtkRenderWindowInteractor* interactor);
  vtkRenderWindowInteractor* GetInteractor();
  ///@}

  ///@{
  /** Starts or stops the timer. */
  void Start();
  void Stop();
  ///@}

  /** Shows one frame immediately, as the timer does. */
  void ShowFrame();

protected:
  vtkFrameClock();
  ~vtkFrameClock() override;

private:
  vtkFrameClock(const vtkFrameClock&) = delete;
  void operator=(const vtkFrameClock&) = delete;

  void Tick();

  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  int Timer = 0;
  unsigned long Observer = 0;
  std::chrono::steady_clock::time_point NextFrame; ///< earliest time of the next frame
};

#endif
