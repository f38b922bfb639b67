// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticDevice
 * @brief the device of a vtkHapticSession: its kind, its mapping to the body, the path of the hand
 *
 * Lengths in mm and forces in N, in the body's frame. The device itself uses SI units; the
 * workspace mapping converts them.
 *
 * The devices that Open accepts are:
 * - "simulated" (default): a stiff hand whose motion does not depend on the force. In virtual time
 *   it follows SetPath; with the session's RealTime it follows SteerTo, for example from a mouse.
 *   Its maximum force is SimulatedForce. Neither stiffness nor energy is limited, because the force
 *   does not act on the motion.
 * - "plant:mass=0.1,damping=1,stiffness=300": a simulated device that moves with the force: m dv/dt
 *   = F + hand - b v. It has the mass m (kg, default 0.1) and the viscous damping b (N s/m, default
 *   1). A hand with a stiffness (N/m, default 300) and a hand-damping (N s/m, default 5) pulls the
 *   device towards the path, or towards the target of SteerTo. The force acts on the motion, so
 *   that stiffness cap and passivity control work as on a real device with this damping. They limit
 *   springs to b/(T + 2t), where T is the inverse of the session's Rate and t the sum of the
 *   delays. The maximum force is 10 N. Further settings are friction (N), encoder-step (m),
 *   force-delay and sample-delay (s), and hand-force (N); see palpate::readPlant. Settings that are
 *   not given, and all settings of "plant" alone, have their defaults.
 * - "replay:FILE": the hand of a recorded trajectory.
 * - "hid:PATH": a device with Palpate's force protocol, or a SpaceMouse; needs RealTime.
 * - "bridge:ADDRESS": another process that uses the same reports, "unix:/PATH" or "udp:PORT"; needs
 *   RealTime.
 *
 * C++ code may pass a device of its own (Use).
 *
 * The mapping consists of: the device's origin in the body's frame (Origin); the directions of the
 * device's x axis (Right) and y axis (Up) in the body's frame; and the length in the body per
 * length of the hand (Scale). The stiffness at the hand is the stiffness of the body times the
 * scale.
 *
 * Settings take effect at the session's next Start. A device serves one session at a time, on that
 * session's thread.
 *
 * @code{.py}
 * device = palpate.vtkHapticDevice()
 * device.Open("plant:mass=0.1,damping=1")              # kg, N s/m; or "hid:PATH"
 * device.SetOrigin(0, 0, 50)                           # mm, in the frame of the body
 * device.SetScale(0.5)                                 # mm of the body per mm of the hand
 * session.SetDevice(device)
 * @endcode
 */
#ifndef vtkHapticDevice_h
#define vtkHapticDevice_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
class HapticDevice;
class RecordedSetups;
class WorkspaceMapping;
struct ContactBody;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkHapticDevice : public vtkObject
{
public:
  static vtkHapticDevice* New();
  vtkTypeMacro(vtkHapticDevice, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Chooses the device (see the description of the class) and opens it. Returns false and reports
   * an error if there is no device of this name; the present device is then unchanged.
   */
  bool Open(const std::string& name);
  /** Lists the devices that are plugged in, one per line. If there are none, returns the reason. */
  static std::string ListDevices();

  /** Returns the status in words, such as "connected" or "unplugged, waiting for it to return". */
  std::string GetStatus();
  /** Whether the device exerts a force on a hand. False for a simulated device and for a
   * SpaceMouse. */
  bool GetOutputsForce();
  /** Maximum force of the device, N. */
  double GetMaximumForce();
  /** Whether the device is plugged in or bridged, and not simulated, replayed or passed by C++
   * code. */
  bool IsPhysical();
  /** Whether the device follows SetPath, or SteerTo with RealTime. True for "simulated" and
   * "plant". */
  bool IsSimulated();
  /** Whether the device replays a recorded trajectory, "replay:FILE". */
  bool IsReplay();

  ///@{
  /** Position of the device's origin in the body's frame, mm. Default 0, 0, 0. */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}
  ///@{
  /** Directions of the device's x and y axes in the body's frame. They must be perpendicular to
   * each other and need not have unit length. Defaults: x and y. */
  vtkSetVector3Macro(Right, double);
  vtkGetVector3Macro(Right, double);
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}
  ///@{
  /** Millimetres of the body per millimetre of the hand, > 0. Default 1. */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /** Whether the device moves only in the plane of its x and y axes. Default off. */
  vtkSetMacro(Planar, bool);
  vtkGetMacro(Planar, bool);
  vtkBooleanMacro(Planar, bool);
  ///@}
  ///@{
  /** Whether the mapping is fitted instead of using Origin and Scale. The fitted scale is the
   * smallest one for which the body, with a margin of 10 mm, is within the device's workspace. The
   * centres of body and workspace coincide. Default off. */
  vtkSetMacro(FitWorkspace, bool);
  vtkGetMacro(FitWorkspace, bool);
  vtkBooleanMacro(FitWorkspace, bool);
  ///@}
  ///@{
  /**
   * Maximum force of the device "simulated", N, > 0. Infinite for a device without force feedback,
   * such as a mouse. Default 10.
   */
  vtkSetMacro(SimulatedForce, double);
  vtkGetMacro(SimulatedForce, double);
  ///@}
  ///@{
  /**
   * Bit mask of buttons. While one of these buttons is pressed, the tip does not move and the hand
   * moves freely. With 0, the default, there is no such button.
   */
  vtkSetMacro(ClutchButtons, unsigned int);
  vtkGetMacro(ClutchButtons, unsigned int);
  ///@}

  /** Path of a simulated device in virtual time. It is a polyline with the point array `Time` (s,
   * not decreasing). For a tilted tool it also has the point array `ToolAxis` (3 components, from
   * the tip to the hand). */
  void SetPath(vtkPolyData* path);
  /**
   * Time of the last point of the path that has been in use since Start, s. 0 before Start and
   * without a path.
   */
  double GetPathDuration();
  /** Target of the hand of a simulated device with RealTime, mm. The hand moves to the target on a
   * straight line, even through the body. Before Start this is the starting point of the hand. */
  void SteerTo(const double tip[3]);
  /**
   * Moves the hand of a simulated device with RealTime to a position above a point of the body's
   * surface. `normal` is the outward unit normal at the point. `height` is the height above the
   * point, mm; at a negative height the hand presses. Unlike with SteerTo, the hand does not pass
   * through the body: it rises, moves around the body and descends. It slides over the surface if
   * it presses at both points and the points are close to each other. The depth never exceeds the
   * given depth (palpate::GuidedHand). Before Start this is the starting position. A planar device
   * moves on a straight line.
   */
  void TouchAt(const double point[3], const double normal[3], double height);
  /**
   * Axis of the tool of a simulated device with RealTime. It points from the tip to the hand, in
   * the body's frame, and need not have unit length. If it is zero, the default, the axis is
   * unknown, and the tool is along the normal.
   */
  void TurnTo(const double axis[3]);

#ifndef __VTK_WRAP__
  /** The setups of a replayed file. Times are relative to the first row of the file. Empty for
   * other devices. */
  const palpate::RecordedSetups& GetRecordedSetups();

  /** Uses a device that the caller provides. */
  void Use(std::unique_ptr<palpate::HapticDevice> device);

  /** Called by the session at its start. Reads mapping and path, and makes the hand for a body with
   * these bounds (mm). `rate` is in Hz. Returns "" or an error message. */
  std::string Prepare(const std::shared_ptr<const palpate::ContactBody>& body,
    const double bounds[6], bool realTime, double rate);
  /** Called by the session when it changes to another body, which is not null. */
  void ChangeBody(const std::shared_ptr<const palpate::ContactBody>& body);
  /** Discards the results of Prepare. Called if the session does not start, or before it starts
   * again. */
  void Release();
  /** The hand that Prepare made; null before Prepare. */
  std::shared_ptr<palpate::HapticDevice> GetHand() const;
  const palpate::WorkspaceMapping& GetMapping() const;
  /** Whether the hand moves independently of the force. */
  bool IsStiff() const;
#endif

protected:
  vtkHapticDevice();
  ~vtkHapticDevice() override;

private:
  vtkHapticDevice(const vtkHapticDevice&) = delete;
  void operator=(const vtkHapticDevice&) = delete;

  palpate::WorkspaceMapping ReadMapping(const double bounds[6]) const;
  std::string MakeHandOnPath();

  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Right[3] = { 1.0, 0.0, 0.0 };
  double Up[3] = { 0.0, 1.0, 0.0 };
  double Scale = 1.0;
  bool Planar = false;
  bool FitWorkspace = false;
  unsigned int ClutchButtons = 0;
  double SimulatedForce = 10.0;
  void Touch();

  double Steered[3] = { 0.0, 0.0, 0.0 };
  bool Touches = false; ///< whether TouchAt was called after SteerTo
  double TouchedPoint[3] = { 0.0, 0.0, 0.0 };
  double TouchedNormal[3] = { 0.0, 0.0, 1.0 };
  double TouchedHeight = 0.0;
  double Axis[3] = { 0.0, 0.0, 0.0 };
  vtkSmartPointer<vtkPolyData> Path;

  struct Parts;
  std::unique_ptr<Parts> Kept;
};

#endif
