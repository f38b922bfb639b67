// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticDevice
 * @brief the device of a vtkHapticSession: its kind, its mapping to the body, the path of its hand
 *
 * Body frame, mm and N, everywhere. The device itself uses SI units behind the workspace mapping.
 *
 * Devices, by Open:
 * - "simulated" (default): a stiff hand that does not move with the force. In virtual time it
 *   follows SetPath; with the session's RealTime it follows SteerTo, for example from a mouse. Its
 *   maximum force is SimulatedForce. Neither stiffness nor energy is limited, as no loop is closed
 * through it.
 * - "plant:mass=0.1,damping=1,stiffness=300": a simulated device that the force moves by m
 *   dv/dt = F + hand - b v. It has the mass m (kg, default 0.1) and the viscous damping b (N s/m,
 *   1). A hand of stiffness k (N/m, 300) and hand-damping (N s/m, 5) pulls it towards the path, or
 *   SteerTo. It closes a loop, so that stiffness cap and passivity control act as on a real device
 *   with this damping: no spring above b/(T + 2 delays), where T is one over the session's Rate.
 *   Its maximum force is 10 N. Further settings: friction (N), encoder-step (m), force-delay and
 *   sample-delay (s), hand-force (N), see palpate::readPlant. Settings that are not given, and all
 *   settings of "plant" alone, have their defaults.
 * - "replay:FILE": the hand of a recorded trajectory.
 * - "hid:PATH": a device with Palpate's force protocol, or a SpaceMouse; needs RealTime.
 * - "bridge:ADDRESS": another process that uses the same reports, "unix:/PATH" or "udp:PORT"; needs
 *   RealTime.
 *
 * A C++ caller may give its own device.
 *
 * The mapping consists of the device's origin in the body's frame (Origin), the directions of its x
 * axis (Right) and y axis (Up) there, and the mm of the body per mm of the hand (Scale). The hand
 * perceives the stiffness times the scale.
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
   * Chooses the device, see above, and opens it. Returns false, after an error, if there is no
   * device of this name; the present device is then unchanged.
   */
  bool Open(const std::string& name);
  /** The devices that are plugged in, one line each, or the reason why there are none. */
  static std::string ListDevices();

  /** Status in words: "connected", "unplugged, waiting for it to return". */
  std::string GetStatus();
  /** Whether it exerts a force on a hand. False for a simulated device and for a SpaceMouse. */
  bool GetOutputsForce();
  /** Its maximum force, N. */
  double GetMaximumForce();
  /** Whether it is plugged in or bridged, and not simulated, replayed or given by C++. */
  bool IsPhysical();
  /** Whether it follows SetPath, or SteerTo with RealTime: true for "simulated" and "plant". */
  bool IsSimulated();
  /** Whether it plays a recorded trajectory, "replay:FILE". */
  bool IsReplay();

  ///@{
  /** Position of the device's origin in the body, mm. Default 0, 0, 0. */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}
  ///@{
  /** Directions of the device's x and y axes in the body: at right angles, of any length. Default x
   * and y. */
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
  /** Whether the mapping is fitted, instead of using Origin and Scale: the smallest scale for which
   * the body, with 10 mm around it, is within the device's workspace, with the same centre. Default
   * off. */
  vtkSetMacro(FitWorkspace, bool);
  vtkGetMacro(FitWorkspace, bool);
  vtkBooleanMacro(FitWorkspace, bool);
  ///@}
  ///@{
  /**
   * Maximum force of the device "simulated", N, > 0; infinite: no limit, for a hand that feels no
   * force, such as one that a mouse steers. Default 10.
   */
  vtkSetMacro(SimulatedForce, double);
  vtkGetMacro(SimulatedForce, double);
  ///@}
  ///@{
  /**
   * While any of these buttons of the device (bits) is down, the tip does not move and the hand
   * moves freely. Default 0: none.
   */
  vtkSetMacro(ClutchButtons, unsigned int);
  vtkGetMacro(ClutchButtons, unsigned int);
  ///@}

  /** For a simulated device in virtual time: its path, a polyline with a point array `Time` (s, not
   * decreasing). For a tilted tool also a point array `ToolAxis` (3, from the tip to the hand). */
  void SetPath(vtkPolyData* path);
  /**
   * Time of the last point of the path in use since Start, s; 0 before Start and without a path.
   */
  double GetPathDuration();
  /** For a simulated device with RealTime: the target of the hand, mm, to which it moves on a
   * straight line, also through the body. Before Start: its starting point. */
  void SteerTo(const double tip[3]);
  /**
   * For a simulated device with RealTime: the hand moves to `height` (mm) above a point of the
   * body's surface with an outward unit normal; at a negative height it presses. Unlike SteerTo, it
   * does not pass through the body: it lifts off, moves around the body and comes down, or slides
   * if both places are near and pressed. The depth is never larger than the one set
   * (palpate::GuidedHand). Before Start: its starting place. A planar device goes straight.
   */
  void TouchAt(const double point[3], const double normal[3], double height);
  /**
   * For a simulated device with RealTime: the axis of the tool, from the tip to the hand, in the
   * body's frame; of any length. Zero (default): the axis is unknown, and the tool is along the
   * normal.
   */
  void TurnTo(const double axis[3]);

#ifndef __VTK_WRAP__
  /** The setups of a replayed file, by its times from its first row on; empty for other devices. */
  const palpate::RecordedSetups& GetRecordedSetups();

  /** Uses a device given by the caller. */
  void Use(std::unique_ptr<palpate::HapticDevice> device);

  /** Called by the session at its start: reads mapping and path, and makes the hand, for a body
   * with these bounds (mm), at `rate` (Hz). Returns "" or an error. */
  std::string Prepare(const std::shared_ptr<const palpate::ContactBody>& body,
    const double bounds[6], bool realTime, double rate);
  /** Called by the session when it changes over to another body, not null. */
  void ChangeBody(const std::shared_ptr<const palpate::ContactBody>& body);
  /** Discards the results of Prepare, if the session does not start, or starts again. */
  void Release();
  /** The hand made by Prepare; null before. */
  std::shared_ptr<palpate::HapticDevice> GetHand() const;
  const palpate::WorkspaceMapping& GetMapping() const;
  /** Whether the hand of the device moves independently of the force. */
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
  bool Touches = false; ///< whether TouchAt was called last
  double TouchedPoint[3] = { 0.0, 0.0, 0.0 };
  double TouchedNormal[3] = { 0.0, 0.0, 1.0 };
  double TouchedHeight = 0.0;
  double Axis[3] = { 0.0, 0.0, 0.0 };
  vtkSmartPointer<vtkPolyData> Path;

  struct Parts;
  std::unique_ptr<Parts> Kept;
};

#endif
