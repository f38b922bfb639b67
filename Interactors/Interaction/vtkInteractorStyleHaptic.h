// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInteractorStyleHaptic
 * @brief the mouse moves the tool over the body; elsewhere it moves the camera
 *
 * Give it a session (RealTime), the scene that shows it, and call StartSession, or StartUpdates for
 * a session started by others. From then on a repeating timer of the interactor moves the newest
 * tick to the scene, up to 30 times a second, and renders; what mouse, wheel and widgets change is
 * drawn with the next of these frames, so that no event waits for one. Where a frame takes long,
 * half of the time is left to the mouse. It never waits for the servo thread.
 *
 * **Mouse**, over the body, in the viewport of the scene:
 * - moving: the tool hovers HoverHeight above the surface under the pointer;
 * - left button: it presses, PressDepth deep, and slides with the pointer; wheel: deeper or less
 *   deep, by 0.1 mm a notch;
 * - wheel without a button: it presses too, WheelDepth deep, 0.1 mm more or less a notch; at 0 it
 *   hovers again.
 * - with Steering ViewPlane (key v) the pointer moves the tip in the plane through it that is
 *   parallel to the picture, through free space and body alike, and the wheel moves it away from
 *   the viewer or towards, by 0.1 mm a notch.
 * Elsewhere in the scene, as vtkInteractorStyleTrackballCamera: left orbits, middle pans, right and
 * wheel zoom; the wheel zooms with Control everywhere. In other viewports that are not interactive,
 * a panel or charts, nothing happens.
 *
 * **Keys**: see GetKeyHelp, which ? or h shows and hides on the screen. Those the style cannot
 * serve itself are told to its observers: 1 to 9 ToolChosenEvent (call data: int*, from 0), space
 * SwitchEvent, c CompareEvent, g ChartsEvent, t HistogramEvent.
 *
 * The body is the session's; its response normals are the directions pressed along.
 */
#ifndef vtkInteractorStyleHaptic_h
#define vtkInteractorStyleHaptic_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For vtkCommand::UserEvent
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <chrono> // For std::chrono::steady_clock
#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkContactScene;
class vtkHapticSession;
class vtkRenderer;

namespace palpate
{
class KeyHelp;
class SurfacePicker;
class TickTape;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkInteractorStyleHaptic : public vtkInteractorStyleTrackballCamera
{
public:
  static vtkInteractorStyleHaptic* New();
  vtkTypeMacro(vtkInteractorStyleHaptic, vtkInteractorStyleTrackballCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    ToolChosenEvent = vtkCommand::UserEvent + 401,
    SwitchEvent = vtkCommand::UserEvent + 402,
    FrameEvent = vtkCommand::UserEvent + 403, ///< before the scene is brought up to date and drawn
    SteeredEvent = vtkCommand::UserEvent + 404, ///< call data: double[3], where to, mm
    CompareEvent = vtkCommand::UserEvent + 405,
    ChartsEvent = vtkCommand::UserEvent + 406,
    HistogramEvent = vtkCommand::UserEvent + 407
  };

  /// Values of Steering.
  enum SteeringType
  {
    Surface = 0,
    ViewPlane = 1
  };

  /** The session that is steered; its body must be set when the pointer first moves. The search
   * structure for picking is built then, and kept as long as points and cells are the same. */
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession();
  /** The scene the newest tick is shown in; the pointer steers in its renderer. */
  void SetScene(vtkContactScene* scene);
  vtkContactScene* GetScene();

  ///@{
  /** How the pointer moves the tool, see above. Default Surface. */
  vtkSetClampMacro(Steering, int, Surface, ViewPlane);
  vtkGetMacro(Steering, int);
  void SetSteeringToSurface() { this->SetSteering(Surface); }
  void SetSteeringToViewPlane() { this->SetSteering(ViewPlane); }
  ///@}

  ///@{
  /** How deep the left button presses, mm, 0 to MaximumDepth. Default 1. */
  void SetPressDepth(double depth);
  vtkGetMacro(PressDepth, double);
  ///@}
  ///@{
  /** How deep the wheel alone has pressed, mm, 0 to MaximumDepth; 0 (default): the tool hovers. */
  void SetWheelDepth(double depth);
  vtkGetMacro(WheelDepth, double);
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

  /** Steers the tool to hover above a point of the surface with outward unit normal `normal`. */
  void HoverAt(const double point[3], const double normal[3]);
  /** Steers the tip to a point, mm, body frame. */
  void SteerTo(const double tip[3]);

  /** One frame, at once: FrameEvent, the newest tick into the scene, rendering. What the timer does
   * when it is time. */
  void ShowFrame();

  /** Whether the left button presses the tool now. */
  bool IsPressing() const { return this->Pressing; }

  /** Whether the wheel has ever pressed the tool, or moved it away from the viewer: a window can
   * say that it does until then. */
  bool HasWheelPressed() const { return this->WheelPressed; }

  /** Largest magnitude of force among the ticks shown, N. */
  vtkGetMacro(StrongestForce, double);

  ///@{
  /** Starts the session, and the updates. Returns false after an error of the session. StopSession
   * stops it; the window stays alive. ToggleSession does what is due. Key x. */
  bool StartSession();
  void StopSession();
  void ToggleSession();
  ///@}
  ///@{
  /** Starts or stops the timer; the interactor must be initialised. */
  void StartUpdates();
  void StopUpdates();
  ///@}

  ///@{
  /** The list of keys and what the mouse does, on the screen. Key ?. Default off. */
  void SetHelpVisibility(bool visible);
  bool GetHelpVisibility() const;
  ///@}
  ///@{
  /** What it says: a line per key, "key<tab>what it does". Default: what this class does. */
  void SetKeyHelp(const std::string& text);
  std::string GetKeyHelp() const;
  ///@}

  ///@{
  /** The dent in the scene is drawn twice, or half, as deep as it is; 1 to 64. Keys + and -. */
  void ExaggerateMore();
  void ExaggerateLess();
  ///@}

  ///@{
  /** Where pictures and records go under names of their own, "palpate-1.png", "palpate-1.csv", the
   * first number that is free. Made when needed. Default: the folder the program runs in. */
  vtkSetMacro(OutputFolder, std::string);
  vtkGetMacro(OutputFolder, std::string);
  ///@}
  /** Writes the window as a .png; "": under a name of its own. Returns the name of the file, ""
   * after an error. Key p. */
  std::string WritePicture(const std::string& fileName = std::string());
  ///@{
  /**
   * Keeps every tick from StartRecording on, then writes them as a trajectory file that the device
   * "replay:FILE" reads; "": under a name of its own. The session must have HistorySeconds of some
   * frames at its Start, 1 is plenty: ticks are taken from there once a frame. Starting returns
   * false, after an error, if it has none; writing returns the name of the file, "" after an error.
   * ToggleRecording does what is due. Key k.
   */
  bool StartRecording();
  std::string WriteRecording(const std::string& fileName = std::string());
  void ToggleRecording();
  bool IsRecording() const;
  /** Ticks kept since StartRecording. */
  vtkIdType GetNumberOfRecordedTicks() const;
  ///@}
  ///@{
  /** What was last done, in words: "picture palpate-1.png"; for whoever shows it. */
  vtkSetMacro(Notice, std::string);
  vtkGetMacro(Notice, std::string);
  ///@}

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
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

  vtkRenderer* FindSceneRenderer();
  bool IsBesideScene();
  bool PickSurface(double point[3], double normal[3]);
  bool Steer();
  bool SteerOverSurface();
  bool SteerInView(double away);
  bool TurnWheel(double notches);
  bool DoKey(char key);
  std::string FreeName(const char* ending);

  vtkSmartPointer<vtkHapticSession> Session;
  vtkSmartPointer<vtkContactScene> Scene;
  std::unique_ptr<palpate::SurfacePicker> Picker;
  std::unique_ptr<palpate::KeyHelp> Help;
  std::unique_ptr<palpate::TickTape> Tape;
  int Steering = Surface;
  double PressDepth = 1.0;
  double WheelDepth = 0.0;
  double MaximumDepth = 2.0;
  double HoverHeight = 3.0;
  bool Pressing = false;
  bool WheelPressed = false;
  double HoverNormal[3] = { 0.0, 0.0, 0.0 }; ///< of the surface last steered over
  double SteeredTip[3] = { 0.0, 0.0, 0.0 };
  double StrongestForce = 0.0;
  int Timer = 0;
  std::string OutputFolder;
  std::string Notice;
  std::chrono::steady_clock::time_point NextFrame; ///< not before
};

#endif
