// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticSession
 * @brief the contact of a haptic device with a body that has responses, tick by tick
 *
 * Set a body (with response arrays) and, for the simulated device, a path. Call Start. In virtual
 * time, then call Step and read the contact. The results in virtual time do not depend on the
 * machine: the same steps give the same bits. With RealTime, Start starts the servo thread at Rate.
 * Step then has no effect, and the getters return the newest tick.
 *
 * The parts of a session are separate objects, never null. They may be exchanged while the session
 * is stopped:
 * - GetDevice: the device, its mapping to the body, the path of the hand;
 * - GetSettings: the settings of the contact;
 * - GetSafety: the limits of a force before it reaches the hand;
 * - GetRecorder: the recorded ticks, and their timing.
 *
 * Lengths in mm and forces in N, in the body's frame. There are two forces: the ideal force of the
 * contact, and the applied force. The safety chain makes the applied force from the ideal force, to
 * fit it to the device (force factor, stiffness cap, limits, passivity). GetSafetyText names the
 * links that acted.
 *
 * ApplyChanges passes another body, response or settings to a running session, also during contact:
 * the force changes to its new value within 50 ms.
 *
 * If a device is lost, the session continues with no force, in the state DeviceLost, until the
 * device returns.
 *
 * AddDevice puts further devices on the same body, up to four in total. Each has its own mapping
 * and safety chain. One loop computes the ticks of all devices at the same times. If the response
 * of the body has a coupling (vtkToolContactResponse), the tools affect one another through the
 * deflection of the surface; a lost device has no effect on the others. Devices are numbered from
 * 0; number 0 is the device of GetDevice. For an invalid index, getters return the values before
 * the first tick.
 *
 * Defects of the body's mesh are reported in one warning, as by vtkToolContactProbe.
 *
 * Not thread-safe: one thread steers, steps and reads. It waits for the servo thread only in Stop
 * and Start.
 *
 * @code{.py}
 * session = palpate.vtkHapticSession()
 * session.SetBody(body)                                # with a response
 * session.GetDevice().SetPath(path.GetOutput())        # vtkPressPath
 * session.Start()
 * session.Step(0.5 * session.GetDevice().GetPathDuration())  # s, in virtual time
 * session.GetIdealForce(force := [0.0, 0.0, 0.0])      # N, of the newest tick
 * session.Stop()
 * @endcode
 */
#ifndef vtkHapticSession_h
#define vtkHapticSession_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkContactSettings.h"       // Its parts
#include "vtkHapticDevice.h"
#include "vtkHapticRecorder.h"
#include "vtkHapticSafety.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkPolyData;

namespace palpate
{
struct BodyKernels;
struct ContactBody;
struct RecordedSetup;
struct SafetySettings;
struct ServoScene;
class SessionRun;
struct Tick;
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
    DeviceLost = 2 ///< running without force: the device reports no position
  };

  ///@{
  /** The body with its response arrays; read at Start and ApplyChanges. */
  void SetBody(vtkPolyData* body);
  vtkPolyData* GetBody();
  ///@}

#ifndef __VTK_WRAP__
  /**
   * Sets the body, and the kernels that Start and ApplyChanges would otherwise make from its
   * responses. If the kernels are made in the background, Start and ApplyChanges take no time for
   * them. The kernels are valid for one Start, and until the body is changed.
   */
  void SetBody(vtkPolyData* body, palpate::BodyKernels kernels);
#endif

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /**
   * The settings of the contact. Other sessions may share them. Read at Start and ApplyChanges,
   * which fail with an error if a value is out of its range. Null sets a separate object with the
   * default values, which is also the default.
   */
  void SetSettings(vtkContactSettings* settings);
  vtkContactSettings* GetSettings();
  ///@}
  ///@{
  /**
   * The device. Read at Start, except for the target of a simulated hand. Null sets a separate
   * "simulated" device, which is also the default.
   */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}
  ///@{
  /**
   * Adds a device, with a name as in vtkHapticDevice::Open. It takes part after the next Start.
   * Returns its index, or -1 after an error. Path, mapping and steering of the device are set on
   * GetDevice(index), which is null for an invalid index. RemoveAddedDevices keeps only the first
   * device.
   */
  int AddDevice(const std::string& name);
  void RemoveAddedDevices();
  int GetNumberOfDevices() const
  {
    return 1 + static_cast<int>(this->Added.size());
  }
  vtkHapticDevice* GetDevice(int index);
  ///@}
  ///@{
  /**
   * The safety chain. Read at Start; the fit of the force also at ApplyChanges. Null sets a
   * separate object, which is also the default.
   */
  void SetSafety(vtkHapticSafety* safety);
  vtkHapticSafety* GetSafety();
  ///@}
  ///@{
  /** The recorder of the ticks. Read at Start. Null sets a separate object, which is also the
   * default. */
  void SetRecorder(vtkHapticRecorder* recorder);
  vtkHapticRecorder* GetRecorder();
  ///@}

  ///@{
  /**
   * Name of the body, such as its file, and its material in words, for records: a trajectory file
   * names them, and a replay compares them. vtkContactSetup sets the material, "E = 0.05 MPa, nu =
   * 0.45". Default "": not known.
   */
  vtkSetMacro(BodyName, std::string);
  vtkGetMacro(BodyName, std::string);
  vtkSetMacro(Material, std::string);
  vtkGetMacro(Material, std::string);
  ///@}

  ///@{
  /** Ticks per second, 1 to 100000. Default 1000. */
  vtkSetClampMacro(Rate, double, 1.0, 100000.0);
  vtkGetMacro(Rate, double);
  ///@}

  ///@{
  /** Whether ticks run on a servo thread instead of in virtual time. Read at Start. Default off. */
  vtkSetMacro(RealTime, bool);
  vtkGetMacro(RealTime, bool);
  vtkBooleanMacro(RealTime, bool);
  ///@}

  ///@{
  /**
   * With RealTime: time before each tick at which the servo thread wakes up and computes the
   * contact in advance (rehearsal), s, 0 to half a period; see ServoLoopSettings. Rehearsal
   * shortens the delay from the sample to the force, but each tick needs this additional processor
   * time. Default 0: the thread sleeps until the tick.
   */
  vtkSetMacro(Rehearsal, double);
  vtkGetMacro(Rehearsal, double);
  ///@}

  ///@{
  /**
   * With RealTime: whether the memory of the process is locked against paging, if the system
   * permits it. Only the program may decide this, so a library does not do it by default. Default
   * off.
   */
  vtkSetMacro(LockMemory, bool);
  vtkGetMacro(LockMemory, bool);
  vtkBooleanMacro(LockMemory, bool);
  ///@}

  /** Ticks made since Start. */
  vtkIdType GetNumberOfTicks() const;
  /** Number of successful calls of Start. It identifies the run. */
  vtkIdType GetNumberOfStarts() const
  {
    return this->Starts;
  }

  /** Reads the body and the path, and starts at time 0. Returns false after an error; the error
   * names the fault. */
  bool Start();
  void Stop();
  /** Stops the session if it runs, otherwise starts it. */
  void Toggle();

  /**
   * Passes the present body, ResponseName and contact settings to the running session. The force
   * changes to its new value within 50 ms, also during contact. If two calls follow in quick
   * succession, the later one takes effect. No effect if the session does not run. Returns false
   * after an error, which names the fault; the session then continues unchanged.
   */
  bool ApplyChanges();

  /** Computes all ticks that are due in the next `seconds` of virtual time. Only the sum of all
   * steps matters, not their lengths. No effect if the session does not run, or if `seconds` is
   * not positive and finite. */
  void Step(double seconds);

  int GetState() const;
  /** State of one of several devices. Each device has its own state; one can be in the state
   * DeviceLost while the others run. */
  int GetState(int device) const;
  /** Virtual time of the next tick, s. */
  double GetTime() const;

  ///@{
  /** Values of the newest tick: tip; contact point; total force on the tool (GetIdealForce: ideal,
   * GetForce: applied by the device); friction as part of it; normal; deflection; and contact
   * state as in vtkToolContactProbe. Zeros before the first tick. */
  void GetTip(double tip[3]);
  void GetContactPoint(double point[3]);
  void GetIdealForce(double force[3]);
  void GetForce(double force[3]);
  void GetFrictionForce(double force[3]);
  void GetNormal(double normal[3]);
  /** Cell of the body that is in contact; -1 without contact. */
  vtkIdType GetContactCell();
  double GetDeflection();
  int GetContactState();
  ///@}
  ///@{
  /**
   * Values of the newest tick of a tilted tool: its axis, a unit vector from the tip to the hand;
   * the ideal torque on the tool about its tip, N mm; the torque applied by a device that outputs
   * torque, N mm; its tilt from the normal, degrees. All zero if the device does not report its
   * orientation.
   */
  void GetAxis(double axis[3]);
  void GetIdealTorque(double torque[3]);
  void GetTorque(double torque[3]);
  double GetTilt();
  ///@}
  ///@{
  /** As above, for one of several devices, given by its index. */
  void GetTip(int device, double tip[3]);
  void GetContactPoint(int device, double point[3]);
  void GetIdealForce(int device, double force[3]);
  void GetForce(int device, double force[3]);
  void GetFrictionForce(int device, double force[3]);
  void GetNormal(int device, double normal[3]);
  vtkIdType GetContactCell(int device);
  double GetDeflection(int device);
  int GetContactState(int device);
  void GetAxis(int device, double axis[3]);
  void GetIdealTorque(int device, double torque[3]);
  void GetTorque(int device, double torque[3]);
  double GetTilt(int device);
  std::string GetSafetyText(int device);
  ///@}
  /**
   * Factor by which the ideal force of the newest tick was scaled to fit the device. Before the
   * first tick: the factor chosen at Start.
   */
  double GetForceFactor();
  /** Reason for the factor, such as "the device is too weak: 10 N of 52.3 N"; "" if the factor is
   * 1. */
  std::string GetFitReason() const
  {
    return this->FitReason;
  }
  /**
   * Largest force that can reach the hand, N: the smaller of the device's maximum force and the
   * limit of the safety chain.
   */
  double GetMaximumForce();
  /**
   * Text with the reasons for a difference between applied force and ideal force, and the factor,
   * for example "force ×0.12 (the device is too weak: 10 N of 83.3 N), stiffness capped". "" if the
   * forces do not differ.
   */
  std::string GetSafetyText();

  /**
   * With a device "replay:FILE": a sentence with the recorded body, tool, material, model and
   * friction at this place of the record, or with those that differ from the session's. "" for
   * other devices.
   */
  std::string GetReplayText();

#ifndef __VTK_WRAP__
  /** Body, tool, material, model and friction in words. */
  palpate::RecordedSetup GetSetup();

  /** The complete newest tick, valid until the next call; a default tick before the first tick. */
  const palpate::Tick& GetNewestTick();
  const palpate::Tick& GetNewestTick(int device);
#endif

  /** Includes the modification times of the session's parts. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticSession();
  ~vtkHapticSession() override;

private:
  vtkHapticSession(const vtkHapticSession&) = delete;
  void operator=(const vtkHapticSession&) = delete;

  struct Hand;
  template <class Part>
  void Exchange(vtkSmartPointer<Part>& held, Part* part);
  const palpate::Tick& Newest(int device) const;
  std::vector<vtkHapticDevice*> Devices() const;
  std::shared_ptr<const palpate::ContactBody> ReadBody(const std::string& responseName);
  void WarnOfDefects(const palpate::ContactBody& kernel);
  bool CheckSettings();
  bool PrepareDevices();
  void ReleaseDevices();
  bool ReadSafety(std::vector<Hand>& hands);
  std::unique_ptr<palpate::ServoScene> MakeScene(const std::vector<Hand>& hands);
  bool FitToDevice(
    const palpate::SafetySettings& safety, double scale, double& factor, std::string& reason);
  std::shared_ptr<palpate::SessionRun> MakeRun(const std::vector<Hand>& hands);
  bool StartRun(const std::vector<Hand>& hands);

  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkContactSettings> Settings;
  vtkSmartPointer<vtkHapticDevice> Device;
  std::vector<vtkSmartPointer<vtkHapticDevice>> Added;
  vtkSmartPointer<vtkHapticSafety> Safety;
  vtkSmartPointer<vtkHapticRecorder> Recorder;
  std::string ResponseName = "Response";
  std::string BodyName;
  std::string Material;
  double Rate = 1000.0;
  bool RealTime = false;
  bool LockMemory = false;
  double Rehearsal = 0.0;
  vtkIdType Starts = 0;
  double FittedFactor = 1.0; ///< force factor of the newest servo scene
  std::string FitReason;     ///< reason for a factor below 1; "" if the factor is 1

  // Body and modification time for which defects were reported last.
  vtkPolyData* Unsound = nullptr;
  vtkMTimeType UnsoundTime = 0;

  struct Kernels;
  struct Started;
  std::unique_ptr<Kernels> Known;
  std::unique_ptr<Started> Run;
};

#endif
