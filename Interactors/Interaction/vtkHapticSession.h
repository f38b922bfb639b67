// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticSession
 * @brief a haptic device over a body with responses, tick by tick
 *
 * Give it a body (with response arrays) and, for the simulated device, a path; Start it, Step it in
 * virtual time, read what is felt. In virtual time nothing depends on the machine: the same steps
 * give the same bits. With RealTime, Start starts the servo thread at Rate; Step does nothing, and
 * the getters give the newest tick.
 *
 * Its parts are objects of their own, never null, that may be exchanged while nothing runs:
 * - GetDevice: which device, where it lies in the body, where its hand goes;
 * - GetSettings: how the contact feels;
 * - GetSafety: what a force must keep to before it reaches the hand;
 * - GetRecorder: the ticks that are kept, and how they kept time.
 *
 * Body frame, mm and N, everywhere. Two forces are told: the ideal one, and the one applied after
 * the safety chain has fitted it to the device (force factor, stiffness cap, limits, passivity);
 * GetSafetyText says what acted.
 *
 * ApplyChanges gives a running session another body, response or settings, in contact too: the
 * force goes over within 50 ms.
 *
 * A device that is lost leaves the session running, with no force, in the state DeviceLost, until
 * it returns.
 *
 * AddDevice puts further devices, up to four in all, on the same body, each with a mapping and a
 * safety chain of its own: all tick in one loop, at one time. On a body whose response tells how
 * its contacts feel one another (vtkToolContactResponse) they do; a device that is lost is felt by
 * the others no more. Another body or other settings then come after no force, 50 ms down and 50
 * up. What is told of a device is told by its index, 0 the one of GetDevice; of an index that none
 * has, what a session tells before the first tick.
 *
 * What is wrong with the mesh of the body is said in one warning, as by vtkToolContactProbe.
 *
 * Not thread-safe: one thread steers, steps and reads; it never waits for the servo thread but in
 * Stop and Start.
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
  /** How the contact feels: an object that others may share. Read at Start and ApplyChanges, which
   * fail with an error if a value is out of its range. Default, and in place of null: one of its
   * own with the defaults. */
  void SetSettings(vtkContactSettings* settings);
  vtkContactSettings* GetSettings();
  ///@}
  ///@{
  /** The device. Read at Start, but for where a simulated hand is steered to. Default, and in place
   * of null: one of its own, "simulated". */
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}
  ///@{
  /** Further devices, from the next Start on: of a name as of vtkHapticDevice::Open; returns its
   * index, or -1 after an error. A path, mapping and steering are each one's own: GetDevice(index),
   * null for none. RemoveAddedDevices leaves the first. */
  int AddDevice(const std::string& name);
  void RemoveAddedDevices();
  int GetNumberOfDevices() const
  {
    return 1 + static_cast<int>(this->Added.size());
  }
  vtkHapticDevice* GetDevice(int index);
  ///@}
  ///@{
  /** The safety chain. Read at Start, the fit of the force at ApplyChanges too. Default, and in
   * place of null: one of its own. */
  void SetSafety(vtkHapticSafety* safety);
  vtkHapticSafety* GetSafety();
  ///@}
  ///@{
  /** What is kept of the ticks. Read at Start. Default, and in place of null: one of its own. */
  void SetRecorder(vtkHapticRecorder* recorder);
  vtkHapticRecorder* GetRecorder();
  ///@}

  ///@{
  /** Ticks per second, 1 to 100000. Default 1000. */
  vtkSetClampMacro(Rate, double, 1.0, 100000.0);
  vtkGetMacro(Rate, double);
  ///@}

  ///@{
  /** Run on a servo thread instead of in virtual time; read at Start. Default off. */
  vtkSetMacro(RealTime, bool);
  vtkGetMacro(RealTime, bool);
  vtkBooleanMacro(RealTime, bool);
  ///@}

  ///@{
  /** With RealTime: how long before each tick the servo thread wakes up and makes the contact
   * beforehand, s, 0 to half a period; see ServoLoopSettings. The force comes sooner after the
   * sample, for so much of a processor. Default 0: it sleeps until the tick. */
  vtkSetMacro(Rehearsal, double);
  vtkGetMacro(Rehearsal, double);
  ///@}

  ///@{
  /** With RealTime: keep the memory of the process from being paged out, if the system allows it; a
   * program's own decision. Default off. */
  vtkSetMacro(LockMemory, bool);
  vtkGetMacro(LockMemory, bool);
  vtkBooleanMacro(LockMemory, bool);
  ///@}

  /** Ticks made since Start. */
  vtkIdType GetNumberOfTicks() const;
  /** How often Start has succeeded: what tells one run from the next. */
  vtkIdType GetNumberOfStarts() const
  {
    return this->Starts;
  }

  /** Reads body and path and begins at time 0. Returns false after an error that names the fault.
   */
  bool Start();
  void Stop();
  /** Stops what runs, starts what does not. */
  void Toggle();

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
  /** Of another device: DeviceLost is of each alone. */
  int GetState(int device) const;
  /** Virtual time, s, of the next tick. */
  double GetTime() const;

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
  ///@{
  /** The newest tick of a tilted tool: its axis, unit, from the tip to the hand (zero where the
   * device does not tell it, and of all that follows); the ideal torque on it about its tip, N mm,
   * and the one applied by a device that outputs torque; its tilt from the normal, degrees. */
  void GetAxis(double axis[3]);
  void GetIdealTorque(double torque[3]);
  void GetTorque(double torque[3]);
  double GetTilt();
  ///@}
  ///@{
  /** The same of a device of several, by its index. */
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
  /** By which factor the newest tick's ideal force was fitted to the device; before the first that
   * of Start. */
  double GetForceFactor();
  /** No force larger than this reaches the hand, N: what the device is good for, or the limit of
   * the safety, whichever is less. */
  double GetMaximumForce();
  /** Why the applied force is not the ideal one, in words, the factor included: "force ×0.12,
   * stiffness capped"; "" where it is. */
  std::string GetSafetyText();

#ifndef __VTK_WRAP__
  /** The newest tick, whole: valid until the next call. A default one before the first. */
  const palpate::Tick& GetNewestTick();
  const palpate::Tick& GetNewestTick(int device);
#endif

  /** Its parts count. */
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
  bool CheckSettings();
  bool PrepareDevices();
  void ReleaseDevices();
  bool ReadSafety(std::vector<Hand>& hands);
  std::unique_ptr<palpate::ServoScene> MakeScene(const std::vector<Hand>& hands);
  bool FitToDevice(const palpate::SafetySettings& safety, double scale, double& factor);
  std::shared_ptr<palpate::SessionRun> MakeRun(const std::vector<Hand>& hands);
  bool StartRun(const std::vector<Hand>& hands);

  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkContactSettings> Settings;
  vtkSmartPointer<vtkHapticDevice> Device;
  std::vector<vtkSmartPointer<vtkHapticDevice>> Added;
  vtkSmartPointer<vtkHapticSafety> Safety;
  vtkSmartPointer<vtkHapticRecorder> Recorder;
  std::string ResponseName = "Response";
  double Rate = 1000.0;
  bool RealTime = false;
  bool LockMemory = false;
  double Rehearsal = 0.0;
  vtkIdType Starts = 0;
  double FittedFactor = 1.0; ///< of the newest scene made

  // Which state of which body was last found to be unsound.
  vtkPolyData* Unsound = nullptr;
  vtkMTimeType UnsoundTime = 0;

  struct Kernels;
  struct Started;
  std::unique_ptr<Kernels> Known;
  std::unique_ptr<Started> Run;
};

#endif
