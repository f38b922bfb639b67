// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInteractorStyleHaptic
 * @brief the mouse moves the tool over the body; elsewhere it moves the camera
 *
 * - moving over the body: the tool hovers HoverHeight above the surface under the pointer;
 * - left button on the body: it presses, PressDepth deep, and slides with the pointer;
 * - wheel while pressing: deeper or less deep, by 0.1 mm a notch; elsewhere: zoom;
 * - left button beside the body: orbit; middle: pan; right: zoom; as
 * vtkInteractorStyleTrackballCamera;
 * - keys 1 to 9: the observers of ToolChosenEvent are told the tool's number (call data: int*);
 * - space: the observers of SwitchEvent are told.
 *
 * Give it a session (RealTime) and the scene that shows it. A repeating timer of the interactor
 * moves the newest tick to the scene, up to 30 times a second, and renders; where a frame takes
 * long, half of the time is left to the mouse. It never waits for the servo thread. The body is the
 * session's; its response normals are the directions pressed along.
 */
#ifndef vtkInteractorStyleHaptic_h
#define vtkInteractorStyleHaptic_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For vtkCommand::UserEvent
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <chrono> // For std::chrono::steady_clock

class vtkContactScene;
class vtkHapticSession;
class vtkPolyData;
class vtkStaticCellLocator;

class PALPATEINTERACTION_EXPORT vtkInteractorStyleHaptic : public vtkInteractorStyleTrackballCamera
{
public:
  static vtkInteractorStyleHaptic* New();
  vtkTypeMacro(vtkInteractorStyleHaptic, vtkInteractorStyleTrackballCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    ToolChosenEvent = vtkCommand::UserEvent + 401,
    SwitchEvent = vtkCommand::UserEvent + 402
  };

  /** The session that is steered; its body must be set. The search structure for picking is built
   * at the first pick. */
  void SetSession(vtkHapticSession* session);
  /** The scene the newest tick is shown in. */
  void SetScene(vtkContactScene* scene);

  ///@{
  /** How deep the left button presses, mm, 0 to MaximumDepth. Default 1. */
  void SetPressDepth(double depth);
  vtkGetMacro(PressDepth, double);
  ///@}
  ///@{
  /** Default 2 mm. */
  vtkSetMacro(MaximumDepth, double);
  vtkGetMacro(MaximumDepth, double);
  ///@}
  ///@{
  /** Height of the tool over the surface while it does not press, mm. Default 3. */
  vtkSetMacro(HoverHeight, double);
  vtkGetMacro(HoverHeight, double);
  ///@}

  ///@{
  /** Whether the scene's remark tells the applied force, by which factor and why it is not the
   * ideal one, and what the device says if it is lost. Default on. */
  vtkSetMacro(ShowsSafety, bool);
  vtkGetMacro(ShowsSafety, bool);
  ///@}

  /** Steers the tool to hover above a point of the surface with outward unit normal `normal`. */
  void HoverAt(const double point[3], const double normal[3]);

  /** Whether the left button presses the tool now. */
  bool IsPressing() const { return this->Pressing; }

  /** Largest magnitude of force among the ticks shown, N. */
  vtkGetMacro(StrongestForce, double);

  /** Starts the timer; call once the interactor is initialised. */
  void StartUpdates();

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnChar() override;
  void OnTimer() override;

protected:
  vtkInteractorStyleHaptic();
  ~vtkInteractorStyleHaptic() override;

private:
  vtkInteractorStyleHaptic(const vtkInteractorStyleHaptic&) = delete;
  void operator=(const vtkInteractorStyleHaptic&) = delete;

  void TellSafety();
  bool PickSurface(double point[3], double normal[3]);
  bool Steer();
  void SteerTo(const double point[3], const double normal[3], double height);

  vtkSmartPointer<vtkHapticSession> Session;
  vtkSmartPointer<vtkContactScene> Scene;
  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkStaticCellLocator> Locator;
  double PressDepth = 1.0;
  double MaximumDepth = 2.0;
  double HoverHeight = 3.0;
  bool Pressing = false;
  bool ShowsSafety = true;
  double HoverNormal[3] = { 0.0, 0.0, 0.0 }; ///< of the surface last steered over
  double StrongestForce = 0.0;
  std::chrono::steady_clock::time_point NextFrame; ///< not before
};

#endif
