// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkInteractorStyleHaptic
 * @brief moves the tool with the mouse over the body, and the camera elsewhere
 *
 * Set a session (with RealTime) and the scene that shows the session; a vtkFrameClock draws the
 * scene. The style never waits for the servo thread.
 *
 * **Mouse**, over the body, in the viewport of the scene:
 * - moving: the tool hovers HoverHeight above the surface under the pointer; if the pointer jumps,
 *   the tool moves around the body (vtkHapticDevice::TouchAt);
 * - left button: the tool presses with the depth PressDepth and slides with the pointer; the wheel
 *   changes the depth by 0.1 mm per notch; if the wheel already presses the tool, the depth does
 *   not change;
 * - wheel without a button: the tool presses with the depth WheelDepth; each notch changes
 *   WheelDepth by 0.1 mm; at 0 the tool hovers again;
 * - wheel with Shift, and keys [ ] { }: tilt the tool by 2.5 degrees relative to the surface normal
 *   (with ViewPlane, relative to the direction to the viewer); key 0 makes the tool upright;
 * - with Steering ViewPlane (key v), the pointer moves the tip in the plane through the tip
 *   parallel to the picture, both in free space and in the body. The wheel moves the tip away from
 *   the viewer or towards the viewer, by 0.1 mm per notch.
 *
 * A pressing tool does not move while the pointer is not over the body (IsPointerOffBody).
 *
 * Elsewhere in the scene the mouse acts as in vtkInteractorStyleTrackballCamera: the left button
 * orbits, the middle button pans, the right button and the wheel zoom. With Control the wheel zooms
 * everywhere. In other viewports that are not interactive, such as a panel or charts, the mouse has
 * no effect.
 *
 * For a session with several devices, the pointer moves one hand at a time, given by Hand. Key n
 * changes to the next simulated hand. The other hands do not move and continue to press.
 *
 * **Keys** are listed by GetKeyHelp; ? or h shows and hides this list on the screen. For keys that
 * the style does not handle itself, it invokes events: 1 to 9 ToolChosenEvent (call data: int*,
 * from 0), space SwitchEvent, c CompareEvent, g ChartsEvent, t HistogramEvent.
 *
 * The body is that of the session. The tool presses along the normals of its response.
 *
 * @code{.py}
 * style = palpate.vtkInteractorStyleHaptic()
 * style.SetSession(session)                            # with RealTime
 * style.SetScene(scene)
 * style.SetPressDepth(1.0)                             # mm
 * interactor.SetInteractorStyle(style)
 * @endcode
 */
#ifndef vtkInteractorStyleHaptic_h
#define vtkInteractorStyleHaptic_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkCommand.h"               // For vtkCommand::UserEvent
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkContactScene;
class vtkHapticDevice;
class vtkHapticSession;
class vtkRenderer;
class vtkSessionFiles;

namespace palpate
{
class KeyHelp;
class SurfacePicker;
struct SteeredHand;
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
    SteeredEvent = vtkCommand::UserEvent + 403, ///< call data: double[3], new target of the tip, mm
    CompareEvent = vtkCommand::UserEvent + 404,
    ChartsEvent = vtkCommand::UserEvent + 405,
    HistogramEvent = vtkCommand::UserEvent + 406
  };

  /// Values of Steering.
  enum SteeringType
  {
    Surface = 0,
    ViewPlane = 1
  };

  /** The session that is steered. Set its body before the first movement of the pointer, because
   * that movement builds the search structure for picking. The structure is used as long as points
   * and cells are unchanged. */
  void SetSession(vtkHapticSession* session);
  vtkHapticSession* GetSession();
  /** The scene that shows the session. The pointer steers the tool within the renderer of the
   * scene. */
  void SetScene(vtkContactScene* scene);
  vtkContactScene* GetScene();
  ///@{
  /** The object that writes the pictures (key p) and the records (key k). Optional. */
  void SetFiles(vtkSessionFiles* files);
  vtkSessionFiles* GetFiles();
  ///@}

  ///@{
  /**
   * Index of the device that the pointer moves. An index that is too large means the last device.
   * Each hand keeps its wheel depth and tilt while another hand is moved. Default 0.
   */
  void SetHand(int hand);
  vtkGetMacro(Hand, int);
  ///@}

  ///@{
  /** The mode in which the pointer moves the tool (see the description of the class). Default
   * Surface. */
  vtkSetClampMacro(Steering, int, Surface, ViewPlane);
  vtkGetMacro(Steering, int);
  void SetSteeringToSurface() { this->SetSteering(Surface); }
  void SetSteeringToViewPlane() { this->SetSteering(ViewPlane); }
  ///@}

  ///@{
  /** Depth to which the left button presses the tool, mm, 0 to MaximumDepth. Not used while the
   * wheel presses. Default 1. */
  void SetPressDepth(double depth);
  vtkGetMacro(PressDepth, double);
  ///@}
  ///@{
  /** Depth to which the wheel presses the tool without a button, mm, 0 to MaximumDepth. With 0, the
   * default, the tool hovers. */
  void SetWheelDepth(double depth);
  double GetWheelDepth() const;
  ///@}
  ///@{
  /** Largest depth to which button and wheel press, mm. Default 2. */
  vtkSetMacro(MaximumDepth, double);
  vtkGetMacro(MaximumDepth, double);
  ///@}
  ///@{
  /** Height of the tool over the surface while it does not press, mm. Default 3. */
  vtkSetMacro(HoverHeight, double);
  vtkGetMacro(HoverHeight, double);
  ///@}

  /**
   * Tilt of the tool against the normal, degrees: to the right of the picture, and away from the
   * viewer. Each is from -60 to 60. A change takes effect with the next movement. Before the first
   * call the axis is not set, and the tool is along the normal.
   */
  void SetTilt(double right, double away);
  void GetTilt(double tilt[2]) const;

  /**
   * Steers the tool to hover above a point of the surface with the outward unit normal `normal`.
   */
  void HoverAt(const double point[3], const double normal[3]);
  /** Steers the tip to a point on a straight line. The point is in mm, in the body frame. */
  void SteerTo(const double tip[3]);
  /** Steers another device to the last target of the current hand, in the same way. */
  void SteerAlike(vtkHapticDevice* device) const;

  /** Whether the left button is pressing the tool. */
  bool IsPressing() const { return this->Pressing; }

  /**
   * Whether the wheel has ever pressed the tool or moved it away from the viewer. A window can
   * explain the wheel until this function returns true.
   */
  bool HasWheelPressed() const { return this->WheelPressed; }
  /**
   * Whether the pointer is in the viewport of the scene but not over the body while the tool
   * presses. The tool then keeps its position and its depth. A window should inform the user.
   */
  bool IsPointerOffBody();
  /** Whether the last turn of the wheel was limited by MaximumDepth. */
  bool IsAtGreatestDepth() const { return this->AtGreatestDepth; }

  ///@{
  /** Whether the list of keys and mouse functions is shown on the screen. The key ? toggles it.
   * Default off. */
  void SetHelpVisibility(bool visible);
  bool GetHelpVisibility() const;
  ///@}
  ///@{
  /**
   * Text of the list, with one line "key<tab>function" per key. Default: the functions of this
   * class.
   */
  void SetKeyHelp(const std::string& text);
  std::string GetKeyHelp() const;
  ///@}

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnChar() override;
  void OnTimer() override {} ///< empty, because frames of the clock must not move the camera

protected:
  vtkInteractorStyleHaptic();
  ~vtkInteractorStyleHaptic() override;

private:
  vtkInteractorStyleHaptic(const vtkInteractorStyleHaptic&) = delete;
  void operator=(const vtkInteractorStyleHaptic&) = delete;

  vtkRenderer* FindSceneRenderer();
  bool IsOutsideScene();
  bool PickSurface(double point[3], double normal[3]);
  bool Steer();
  bool SteerOverSurface();
  void TouchAt(const double point[3], const double normal[3], double height);
  bool SteerInView(double away);
  bool TurnWheel(double notches);
  void Lean(double right, double away);
  bool DoKey(char key);
  static const char* OwnKeys();
  void FaceAlong(const double direction[3]);
  void Exaggerate(double factor);
  void TakeNextHand();
  palpate::SteeredHand& Steered();
  const palpate::SteeredHand& Steered() const;
  vtkHapticDevice* SteeredDevice();

  vtkSmartPointer<vtkHapticSession> Session;
  vtkSmartPointer<vtkContactScene> Scene;
  vtkSmartPointer<vtkSessionFiles> Files;
  std::unique_ptr<palpate::SurfacePicker> Picker;
  std::unique_ptr<palpate::KeyHelp> Help;
  /// States of the hands that have been steered so far, including the hand with the index Hand.
  std::vector<palpate::SteeredHand> Hands;
  int Hand = 0;
  int Steering = Surface;
  double PressDepth = 1.0;
  double MaximumDepth = 2.0;
  double HoverHeight = 3.0;
  bool Pressing = false;
  /// Whether the wheel was pressing the tool when the button was pressed.
  bool KeepsWheelDepth = false;
  bool WheelPressed = false;
  bool AtGreatestDepth = false;
  bool OffBody = false; ///< whether the last move found no surface while the tool pressed
};

#endif
