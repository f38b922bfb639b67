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
 * The parts of a session are separate objects, never null. They may be replaced while the session
 * is stopped:
 * - GetDevice: the device, its mapping to the body, the path of the hand;
 * - GetSettings: the settings of the contact;
 * - GetSafety: the limits of a force before it reaches the hand;
 * - GetRecorder: the recorded ticks, and their timing.
 *
 * Lengths in mm and forces in N, in the body's frame. There are two forces: the ideal force of the
 * contact, and the applied force. The safety chain computes the applied force from the ideal force,
 * to adapt it to the device (force factor, stiffness cap, limits, passivity). GetSafetyText names
 * the links that acted.
 *
 * ApplyChanges passes another body, response or settings to a running session, even during contact.
 * The force changes to its new value within 50 ms.
 *
 * If a device is lost, the session continues with no force, in the state DeviceLost, until the
 * device returns.
 *
 * AddDevice adds further devices that touch the same body, up to four devices in total. Each has
 * its own mapping and safety chain. One loop computes the ticks of all devices at the same times.
 * If the response of the body has a coupling (vtkToolContactResponse), the tools affect one another
 * through the deflection of the surface. A lost device has no effect on the other devices. Devices
 * are numbered from 0; number 0 is the device of GetDevice. For an invalid index, getters return
 * the values before the first tick.
 *
 * Defects of the body's mesh are reported in one warning, as by vtkToolContactProbe.
 *
 * Not thread-safe: one thread must call all functions. This thread waits for the servo thread only
 * in Stop and Start.
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
    DeviceLost = 2 ///< running without force, because the device reports no position
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
   * them. The kernels are valid for one Start, and only until the body is changed.
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
   * which fail with an error if a value is out of its range. Null sets a new object with the
   * default values, which is also the initial state.
   */
  void SetSettings(vtkContactSettings* settings);
  vtkContactSettings* GetSettings();
  ///@}
  ///@{
  /**
   * The device. Read at Start, except for the target of a simulated hand. Null sets a new
   * "simulated" device, which is also the initial state.
   */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}
  ///@{
  /**
   * Adds a device, with a name as in vtkHapticDevice::Open. The device is used after the next
   * Start. Returns the index of the device, or -1 after an error. Path, mapping and steering of the
   * device are set on GetDevice(index), which is null for an invalid index. RemoveAddedDevices
   * keeps only the first device.
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
   * The safety chain. Read at Start; the fit of the force is also read at ApplyChanges. Null sets a
   * new object, which is also the initial state.
   */
  void SetSafety(vtkHapticSafety* safety);
  vtkHapticSafety* GetSafety();
  ///@}
  ///@{
  /** The recorder of the ticks. Read at Start. Null sets a new object, which is also the initial
   * state. */
  void SetRecorder(vtkHapticRecorder* recorder);
  vtkHapticRecorder* GetRecorder();
  ///@}

  ///@{
  /**
   * Name of the body, such as its file name, and its material in words. Trajectory files contain
   * both, and a replay compares them. vtkContactSetup sets the material, for example "E = 0.05 MPa,
   * nu = 0.45". The default "" means unknown.
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
   * With RealTime, the time before each tick at which the servo thread wakes up and computes the
   * contact in advance (rehearsal), s, 0 to half a period; see ServoLoopSettings. Rehearsal
   * shortens the delay from the sample to the force, but each tick needs this additional processor
   * time. With 0, the default, the thread sleeps until the tick.
   */
  vtkSetMacro(Rehearsal, double);
  vtkGetMacro(Rehearsal, double);
  ///@}

  ///@{
  /**
   * With RealTime, whether the memory of the process is locked against paging if the system permits
   * it. Default off, because locking affects the whole process, and only the program may decide it.
   */
  vtkSetMacro(LockMemory, bool);
  vtkGetMacro(LockMemory, bool);
  vtkBooleanMacro(LockMemory, bool);
  ///@}

  /** Number of ticks since Start. */
  vtkIdType GetNumberOfTicks() const;
  /** Number of successful calls of Start. The number identifies the run. */
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
   * changes to its new value within 50 ms, even during contact. Of two calls in quick succession,
   * the later one takes effect. No effect if the session does not run. Returns false after an
   * error, which names the fault; the session then continues unchanged.
   */
  bool ApplyChanges();

  /** Computes all ticks that are due in the next `seconds` of virtual time. Only the sum of all
   * steps matters, not their lengths. No effect if the session does not run, or if `seconds` is
   * not positive and finite. */
  void Step(double seconds);

  int GetState() const;
  /** State of one of several devices. One device can be in the state DeviceLost while the other
   * devices run. */
  int GetState(int device) const;
  /** Virtual time of the next tick, s. */
  double GetTime() const;

  ///@{
  /** Values of the newest tick. GetIdealForce is the ideal total force on the tool, GetForce the
   * force that the device applies; the friction is a part of the total force. The contact state is
   * that of vtkToolContactProbe. All values are zero before the first tick. */
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
   * Values of the newest tick of a tilted tool: the axis, a unit vector from the tip to the hand;
   * the ideal torque on the tool about its tip, N mm; the torque that the device applies, N mm; and
   * the tilt of the tool from the normal, degrees. All values are zero if the device does not
   * report its orientation.
   */
  void GetAxis(double axis[3]);
  void GetIdealTorque(double torque[3]);
  void GetTorque(double torque[3]);
  double GetTilt();
  ///@}
  ///@{
  /** The same values for the device with the index `device`. */
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
   * first tick it is the factor that was chosen at Start.
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
   * for example "force ×0.12 (the device is too weak: 10 N of 83.3 N), stiffness capped". Returns
   * "" if the forces do not differ.
   */
  std::string GetSafetyText();

  /**
   * With a device "replay:FILE", a sentence about the present time of the record. It names the
   * recorded body, tool, material, model and friction, or those of them that differ from the
   * session's. "" for other devices.
   */
  std::string GetReplayText();

#ifndef __VTK_WRAP__
  /** The setup of the session in words: body, tool, material, model and friction. */
  palpate::RecordedSetup GetSetup();

  /** The complete newest tick, valid until the next call. Before the first tick it is a default
   * tick. */
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

  // The body, and its modification time, whose defects were reported last.
  vtkPolyData* Unsound = nullptr;
  vtkMTimeType UnsoundTime = 0;

  struct Kernels;
  struct Started;
  std::unique_ptr<Kernels> Known;
  std::unique_ptr<Started> Run;
};

#endif
