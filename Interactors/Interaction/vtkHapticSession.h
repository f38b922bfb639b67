// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticSession
 * @brief a haptic device over a body with responses, tick by tick
 *
 * Give it a body (with response arrays), a device and, for the simulated device, a path; Start it,
 * Step it in virtual time, read what is felt. In virtual time nothing depends on the machine: the
 * same steps give the same bits.
 *
 * Body frame, mm and N, everywhere; the device works in SI units behind the workspace mapping.
 *
 * Devices, by SetDevice:
 * - "simulated" (default): a stiff hand that yields to nothing. In virtual time it follows SetPath,
 *   a polyline with a point array `Time` (s, not decreasing); with RealTime it follows SteerTo, as
 *   from a mouse. It is good for 10 N. Neither stiffness nor energy limits it, as no loop is closed
 *   through a hand that does not move with the force.
 * - "plant:mass=0.1,damping=1,stiffness=300": a simulated device that the force moves, m dv/dt =
 *   F + hand - b v: of mass m (kg, default 0.1) and viscous damping b (N s/m, 1), held by a hand of
 *   stiffness k (N/m, 300) and hand-damping (N s/m, 5) towards where the path, or SteerTo, says. It
 *   closes a loop, so that stiffness cap and passivity control act as on a real device of this
 *   damping: no spring above b/(T/2 + delays), T being 1/Rate. It is good for 10 N. Also friction
 * (N), encoder-step (m), force-delay, sample-delay (s) and hand-force (N): see palpate::readPlant.
 * What is not named, and of "plant" all, has its default.
 * - "replay:FILE": the hand of a recorded trajectory.
 * - "hid:PATH": a device with Palpate's force protocol, or a SpaceMouse; needs RealTime.
 * - "bridge:ADDRESS": another process that speaks the same reports, "unix:/PATH" or "udp:PORT";
 *   needs RealTime.
 * C++ may give a device of its own.
 *
 * With RealTime, Start starts the servo thread at Rate; Step does nothing, and the getters give the
 * newest tick. Every tick is recorded there too, as long as somebody reads: what waits unread for
 * more than RecordedSeconds is lost, and counted. HistorySeconds keeps the last ticks alone, for
 * charts of a session without end.
 *
 * Two forces are told: the ideal one, and the one applied after the safety chain has fitted it to
 * the device (force factor, stiffness cap, limits, passivity); GetSafetyText says what acted.
 *
 * ApplyChanges gives a running session another body, response or settings, in contact too: the
 * force goes over within 50 ms.
 *
 * A device that is lost leaves the session running, with no force, in the state DeviceLost, until
 * it returns.
 *
 * What is wrong with the mesh of the body is said in one warning, as by vtkToolContactProbe.
 *
 * Not thread-safe: one thread steers, steps and reads; it never waits for the servo thread but in
 * Stop and Start.
 */
#ifndef vtkHapticSession_h
#define vtkHapticSession_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkContactSettings.h"       // For its macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <limits> // For std::numeric_limits
#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkPolyData;
class vtkTable;

namespace palpate
{
struct BodyKernels;
struct ContactBody;
class HapticDevice;
struct SafetySettings;
struct ServoScene;
struct Tick;
class TickHistory;
struct SessionDevice;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkHapticSession : public vtkObject
{
public:
  static vtkHapticSession* New();
  vtkTypeMacro(vtkHapticSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SessionState
  {
    Stopped = 0,
    Running = 1,
    DeviceLost = 2 ///< it runs, without force: the device tells no position
  };

  ///@{
  /** The body with its response arrays; read at Start and ApplyChanges. */
  void SetBody(vtkPolyData* body);
  vtkPolyData* GetBody();
  ///@}

#ifndef __VTK_WRAP__
  /** The same with what Start and ApplyChanges would make of its responses: where somebody has made
   * that in the background, they take no time. Good until the body is changed, and for one Start.
   */
  void SetBody(vtkPolyData* body, palpate::BodyKernels kernels);
#endif

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /** How the contact feels: an object that others may share, and its properties, which
   * vtkContactSettings explains. Read at Start and ApplyChanges, which fail with an error if one is
   * out of its range. Default: one of its own. */
  palpateContactSettingsMacro();
  ///@}

  ///@{
  /** Ticks per second, 1 to 100000. Default 1000. */
  vtkSetClampMacro(Rate, double, 1.0, 100000.0);
  vtkGetMacro(Rate, double);
  ///@}

  ///@{
  /** Chooses the device, see above, and opens it; it is used from the next Start on. Returns false,
   * after an error, if there is none of this name; the device is then the one before. */
  bool SetDevice(const std::string& device);
#ifndef __VTK_WRAP__
  void SetDevice(std::unique_ptr<palpate::HapticDevice> device);
#endif
  ///@}
  /** In words: "connected", "unplugged, waiting for it to return". */
  std::string GetDeviceStatus();
  /** Whether a hand can feel anything from it: not with a simulated device, nor a SpaceMouse. */
  bool GetDeviceOutputsForce();
  /** The largest force it is given, N: what it is good for, and no more than ForceLimit. */
  double GetDeviceForceLimit();
  /** Whether it is plugged in or bridged, rather than simulated, replayed or given by C++. */
  bool IsDevicePhysical();
  /** Whether it follows SetPath, with RealTime SteerTo: "simulated" and "plant". */
  bool IsDeviceSimulated();
  /** The devices that are plugged in, a line each, or why there is none. */
  static std::string ListDevices();

  ///@{
  /**
   * Workspace mapping, read at Start: where the device's origin lies in the body's frame (mm;
   * default 0, 0, 0), along which directions of the body the device's x (Right) and y (Up) point
   * (at right angles; any length; default x and y), how many mm of the body a mm of the hand is
   * (Scale, > 0; default 1). Stiffness is felt times the scale. A Planar device (default off) moves
   * in the plane of its x and y.
   */
  vtkSetVector3Macro(DeviceOrigin, double);
  vtkGetVector3Macro(DeviceOrigin, double);
  vtkSetVector3Macro(DeviceRight, double);
  vtkGetVector3Macro(DeviceRight, double);
  vtkSetVector3Macro(DeviceUp, double);
  vtkGetVector3Macro(DeviceUp, double);
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  vtkSetMacro(Planar, bool);
  vtkGetMacro(Planar, bool);
  vtkBooleanMacro(Planar, bool);
  ///@}
  ///@{
  /** Instead of DeviceOrigin and Scale: the least scale that puts the body, with 10 mm around it,
   * within the device's workspace, centre on centre. Read at Start. Default off. */
  vtkSetMacro(FitWorkspace, bool);
  vtkGetMacro(FitWorkspace, bool);
  vtkBooleanMacro(FitWorkspace, bool);
  ///@}
  ///@{
  /** While any of these buttons of the device (bits) is down the tip stays and the hand moves
   * freely. Read at Start. Default 0: none. */
  vtkSetMacro(ClutchButtons, unsigned int);
  vtkGetMacro(ClutchButtons, unsigned int);
  ///@}

  ///@{
  /**
   * The links of the safety chain that may be chosen, read at Start. Gate (default on): no force
   * until the tip has been outside once. EntryRamp: seconds over which the force of the first touch
   * rises (default 0). StiffnessCap and PassivityControl (default on): as far as the device says it
   * needs them, see above for "simulated". The limits of force, and that nothing is sent for what
   * is not finite or not heard of, are not to be chosen.
   */
  vtkSetMacro(Gate, bool);
  vtkGetMacro(Gate, bool);
  vtkBooleanMacro(Gate, bool);
  vtkSetMacro(EntryRamp, double);
  vtkGetMacro(EntryRamp, double);
  vtkSetMacro(StiffnessCap, bool);
  vtkGetMacro(StiffnessCap, bool);
  vtkBooleanMacro(StiffnessCap, bool);
  vtkSetMacro(PassivityControl, bool);
  vtkGetMacro(PassivityControl, bool);
  vtkBooleanMacro(PassivityControl, bool);
  ///@}
  ///@{
  /** Beside what the device says of itself: no more force (N) and stiffness (N/m) than this. Read
   * at Start. Default infinite. */
  vtkSetMacro(ForceLimit, double);
  vtkGetMacro(ForceLimit, double);
  vtkSetMacro(StiffnessLimit, double);
  vtkGetMacro(StiffnessLimit, double);
  ///@}

  ///@{
  /**
   * Fit to the device: all forces are scaled by one factor, such that down to FitDepth (mm; default
   * 1) none of the responses compared, at any vertex, exceeds the force and the stiffness that the
   * device is good for. What is compared keeps its ratios then, which limits would level. Default
   * off: the factor is 1. Compared are the responses added and ResponseName. Read at Start and
   * ApplyChanges.
   */
  vtkSetMacro(FitForce, bool);
  vtkGetMacro(FitForce, bool);
  vtkBooleanMacro(FitForce, bool);
  vtkSetMacro(FitDepth, double);
  vtkGetMacro(FitDepth, double);
  void AddFitResponse(const std::string& responseName);
  void ClearFitResponses();
  ///@}

  /** Path of a simulated device: a polyline in the body's frame with a point array `Time`. */
  void SetPath(vtkPolyData* path);

  ///@{
  /** Run on a servo thread instead of in virtual time; read at Start. Default off. */
  vtkSetMacro(RealTime, bool);
  vtkGetMacro(RealTime, bool);
  vtkBooleanMacro(RealTime, bool);
  ///@}

  ///@{
  /** Whether every tick is kept for GetRecording. Read at Start. Default on. With RealTime contacts
   * and peaks are counted among the ticks recorded, or in the history. */
  vtkSetMacro(Recording, bool);
  vtkGetMacro(Recording, bool);
  vtkBooleanMacro(Recording, bool);
  ///@}
  ///@{
  /** With RealTime: how long ticks wait to be read, s, 0.1 to 100; 600 bytes each. Default 5. */
  vtkSetClampMacro(RecordedSeconds, double, 0.1, 100.0);
  vtkGetMacro(RecordedSeconds, double);
  ///@}
  ///@{
  /** Whether the ticks of the last seconds are kept for GetHistory, and how many s: 0 to 100; 600
   * bytes each. With RealTime those that wait to be read, for at most this long if nothing else is
   * recorded. Read at Start. Default 0: none. */
  vtkSetClampMacro(HistorySeconds, double, 0.0, 100.0);
  vtkGetMacro(HistorySeconds, double);
  ///@}
  ///@{
  /** With RealTime: keep the memory of the process from being paged out, if the system allows it; a
   * program's own decision. Default off. */
  vtkSetMacro(LockMemory, bool);
  vtkGetMacro(LockMemory, bool);
  vtkBooleanMacro(LockMemory, bool);
  ///@}

  /** A simulated device with RealTime: where the hand is to go, mm, body frame. Before Start: where
   * it begins. */
  void SteerTo(const double tip[3]);

  /** Ticks made and ticks missed since Start; in virtual time none is missed. */
  vtkIdType GetNumberOfTicks() const;
  vtkIdType GetNumberOfMissedTicks() const;
  /** Ticks made since Start that nobody read in time: neither recording nor history has them. */
  vtkIdType GetNumberOfLostTicks() const;
  /** How often Start has succeeded: what tells one run from the next. */
  vtkIdType GetNumberOfStarts() const
  {
    return this->Starts;
  }

  /** Reads body and path and begins at time 0. Returns false after an error that names the fault.
   */
  bool Start();
  void Stop();

  /**
   * Gives what runs the body, ResponseName and contact settings of now: the force goes over to them
   * within 50 ms, in contact too. Of two calls in quick succession the later one counts. Nothing
   * happens where nothing runs. Returns false after an error that names the fault; what ran goes
   * on then.
   */
  bool ApplyChanges();

  /** Runs all ticks due in the next `seconds` of virtual time; steps add up, whatever their length.
   * Nothing happens unless running, nor for times that are not positive and finite. */
  void Step(double seconds);

  int GetState() const;
  /** Virtual time, s, of the next tick. */
  double GetTime() const;
  /** Time of the path's last point, s; 0 before Start. */
  double GetPathDuration() const;

  ///@{
  /** The newest tick: tip, contact point, total force on the tool (ideal, and applied by the
   * device), the friction in it, deflection, contact state as in vtkToolContactProbe. Zeros before
   * the first. */
  void GetTip(double tip[3]);
  void GetContactPoint(double point[3]);
  void GetIdealForce(double force[3]);
  void GetForce(double force[3]);
  void GetFrictionForce(double force[3]);
  void GetNormal(double normal[3]);
  /** Cell of the body in contact, -1 for none. */
  vtkIdType GetContactCell();
  double GetDeflection();
  int GetContactState();
  ///@}
  /** By which factor the newest tick's ideal force was fitted to the device; before the first that
   * of Start. */
  double GetForceFactor();
  /** Why the applied force is not the ideal one, in words, the factor included: "force ×0.12,
   * stiffness capped"; "" where it is. */
  std::string GetSafetyText();

  /** Every tick since Start, as one polyline of tips with the arrays of vtkToolContactProbe and
   * `Time`, `AppliedForce` (3, N), `ForceFactor` and `SafetyLinks` (int; bits in the order of the
   * chain). Cells are counted as in the newest body. */
  void GetRecording(vtkPolyData* recording);

  /** The same of the last HistorySeconds: the ticks whose time is less than that before the newest.
   */
  void GetHistory(vtkPolyData* history);

  /** One row: ticks, ticks in contact, peak force, applied force and friction (N), peak deflection
   * (mm), median and 99th percentile of the time per tick (ns, wall clock, so they differ from run
   * to run); with RealTime also ticks missed, samples invalid and repeated, forces refused, ticks
   * not recorded, scene changes, and the device's own errors. */
  void GetStatistics(vtkTable* statistics);

  /** With RealTime: columns Share, Period, WakeUp and Tick (us, wall clock): which time that share
   * of the ticks did not exceed, to 1/32; the last row, share 1, is the worst. Empty otherwise. */
  void GetTiming(vtkTable* timing);
  /** With RealTime: how many ticks had which Period, WakeUp and Tick: a row per class of durations,
   * longer than `From (us)` and up to `To (us)`, at most 1/32 apart, from the first to the last
   * that holds any; counts as double. Empty otherwise. */
  void GetTimingHistogram(vtkTable* histogram);
  /** Statistics and timing, in lines for a person. */
  std::string GetStatisticsText();
  /** With RealTime: what the system granted the servo thread, and why not more. */
  std::string GetRealTimeGrant();

  /** Every tick since Start, for C++. */
  const std::vector<palpate::Tick>& GetTicks();
  /** The newest tick, whole, for C++: valid until the next call. A default one before the first. */
  const palpate::Tick& GetNewestTick();
  /** Those of the last HistorySeconds, numbered, for C++. */
  const palpate::TickHistory& GetLastTicks();

  /** The settings count. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticSession();
  ~vtkHapticSession() override;

private:
  vtkHapticSession(const vtkHapticSession&) = delete;
  void operator=(const vtkHapticSession&) = delete;

  const palpate::Tick& Newest() const;

  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkPolyData> Path;
  vtkSmartPointer<vtkContactSettings> Settings;
  std::string ResponseName = "Response";
  double Rate = 1000.0;

  // Which state of which body was last found to be unsound.
  vtkPolyData* Unsound = nullptr;
  vtkMTimeType UnsoundTime = 0;

  struct Kernels;
  struct Started;
  std::shared_ptr<const palpate::ContactBody> ReadBody(const std::string& responseName);
  bool CheckSettings();
  bool ReadMapping(Started& started);
  bool ReadSafety(Started& started);
  bool MakeDevice(Started& started);
  std::unique_ptr<palpate::ServoScene> MakeScene(
    const palpate::SafetySettings& safety, double scale);
  bool FitToDevice(const palpate::SafetySettings& safety, double scale, double& factor);
  bool StartRun(std::unique_ptr<Started> started);

  bool RealTime = false;
  bool Recording = true;
  bool LockMemory = false;
  double RecordedSeconds = 5.0;
  double HistorySeconds = 0.0;
  vtkIdType Starts = 0;
  double Steered[3] = { 0.0, 0.0, 0.0 };
  vtkIdType FirstPoly = 0;

  double DeviceOrigin[3] = { 0.0, 0.0, 0.0 };
  double DeviceRight[3] = { 1.0, 0.0, 0.0 };
  double DeviceUp[3] = { 0.0, 1.0, 0.0 };
  double Scale = 1.0;
  bool Planar = false;
  bool FitWorkspace = false;
  unsigned int ClutchButtons = 0;

  bool Gate = true;
  double EntryRamp = 0.0;
  bool StiffnessCap = true;
  bool PassivityControl = true;
  double ForceLimit = std::numeric_limits<double>::infinity();
  double StiffnessLimit = std::numeric_limits<double>::infinity();

  bool FitForce = false;
  double FitDepth = 1.0;
  std::vector<std::string> FitResponses;
  double FittedFactor = 1.0; ///< of the newest scene made

  std::unique_ptr<palpate::SessionDevice> Chosen;
  std::unique_ptr<Kernels> Known;
  std::unique_ptr<Started> Run;
};

#endif
