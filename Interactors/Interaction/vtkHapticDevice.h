// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticDevice
 * @brief the device of a vtkHapticSession: its kind, its mapping to the body, the path of its hand
 *
 * Body frame, mm and N, everywhere; the device works in SI units behind the workspace mapping.
 *
 * Devices, by Open:
 * - "simulated" (default): a stiff hand that does not move with the force. In virtual time it
 *   follows SetPath; with the session's RealTime it follows SteerTo, as from a mouse. Its maximum
 *   force is 10 N. Neither stiffness nor energy is limited, as no loop is closed through it.
 * - "plant:mass=0.1,damping=1,stiffness=300": a simulated device that the force moves, m
 *   dv/dt = F + hand - b v: of mass m (kg, default 0.1) and viscous damping b (N s/m, 1), held by a
 *   hand of stiffness k (N/m, 300) and hand-damping (N s/m, 5) towards the path, or SteerTo. It
 *   closes a loop, so that stiffness cap and passivity control act as on a real device of this
 *   damping: no spring above b/(T/2 + delays), T being one over the session's Rate. Its maximum
 *   force is 10 N. Also friction (N), encoder-step (m), force-delay, sample-delay (s) and
 *   hand-force (N): see palpate::readPlant. Others, and all of "plant" alone, have their defaults.
 * - "replay:FILE": the hand of a recorded trajectory.
 * - "hid:PATH": a device with Palpate's force protocol, or a SpaceMouse; needs RealTime.
 * - "bridge:ADDRESS": another process that speaks the same reports, "unix:/PATH" or "udp:PORT";
 *   needs RealTime.
 * C++ may give a device of its own.
 *
 * The mapping consists of the device's origin in the body's frame (Origin), the directions of its x
 * (Right) and y (Up) there, and the mm of the body per mm of the hand (Scale). Stiffness is felt
 * times the scale.
 *
 * Settings take effect at the session's next Start. For one session at a time, and its thread.
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
class WorkspaceMapping;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkHapticDevice : public vtkObject
{
public:
  static vtkHapticDevice* New();
  vtkTypeMacro(vtkHapticDevice, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Chooses the device, see above, and opens it. Returns false, after an error, if there is none of
   * this name; the device is then unchanged.
   */
  bool Open(const std::string& name);
  /** The devices that are plugged in, a line each, or why there is none. */
  static std::string ListDevices();

  /** In words: "connected", "unplugged, waiting for it to return". */
  std::string GetStatus();
  /** Whether it exerts a force on a hand: not a simulated device, nor a SpaceMouse. */
  bool GetOutputsForce();
  /** Its maximum force, N. */
  double GetMaximumForce();
  /** Whether it is plugged in or bridged, rather than simulated, replayed or given by C++. */
  bool IsPhysical();
  /** Whether it follows SetPath, or SteerTo with RealTime: "simulated" and "plant". */
  bool IsSimulated();

  ///@{
  /** Position of the device's origin in the body, mm. Default 0, 0, 0. */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}
  ///@{
  /** Where the device's x and y point: at right angles, of any length. Default x and y. */
  vtkSetVector3Macro(Right, double);
  vtkGetVector3Macro(Right, double);
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}
  ///@{
  /** Millimetres of the body to a millimetre of the hand, > 0. Default 1. */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}
  ///@{
  /** Whether the device moves in the plane of its x and y. Default off. */
  vtkSetMacro(Planar, bool);
  vtkGetMacro(Planar, bool);
  vtkBooleanMacro(Planar, bool);
  ///@}
  ///@{
  /** Instead of Origin and Scale: the least scale that puts the body, with 10 mm around it,
   * within the device's workspace, centre on centre. Default off. */
  vtkSetMacro(FitWorkspace, bool);
  vtkGetMacro(FitWorkspace, bool);
  vtkBooleanMacro(FitWorkspace, bool);
  ///@}
  ///@{
  /**
   * While any of these buttons of the device (bits) is down, the tip stays and the hand moves
   * freely. Default 0: none.
   */
  vtkSetMacro(ClutchButtons, unsigned int);
  vtkGetMacro(ClutchButtons, unsigned int);
  ///@}

  /** A simulated device in virtual time: its path, a polyline with a point array `Time` (s, not
   * decreasing), and, for a tool that is tilted, `ToolAxis` (3, from the tip to the hand). */
  void SetPath(vtkPolyData* path);
  /** Time of the last point of the path it follows since Start, s; 0 before, and without a path. */
  double GetPathDuration();
  /** A simulated device with RealTime: the target of the hand, mm. Before Start: its start. */
  void SteerTo(const double tip[3]);
  /**
   * A simulated device with RealTime: the axis, from the tip to the hand, along which it holds the
   * tool, in the body's frame; of any length. Zero, as at first: unknown, so along the normal.
   */
  void TurnTo(const double axis[3]);

#ifndef __VTK_WRAP__
  /** Uses a device of the caller. */
  void Use(std::unique_ptr<palpate::HapticDevice> device);

  /** For the session that starts: reads mapping and path, and makes the hand, over a body of these
   * bounds (mm), at `rate` (Hz). Returns what is wrong, or "". */
  std::string Prepare(const double bounds[6], bool realTime, double rate);
  /** Discards what Prepare made, if the session does not start, or starts again. */
  void Release();
  /** The hand that Prepare made; null before. */
  std::shared_ptr<palpate::HapticDevice> GetHand() const;
  const palpate::WorkspaceMapping& GetMapping() const;
  /** Whether its hand moves independently of the force. */
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
  double Steered[3] = { 0.0, 0.0, 0.0 };
  double Axis[3] = { 0.0, 0.0, 0.0 };
  vtkSmartPointer<vtkPolyData> Path;

  struct Parts;
  std::unique_ptr<Parts> Kept;
};

#endif
