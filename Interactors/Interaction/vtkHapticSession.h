// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticSession
 * @brief a haptic device over a body with responses, tick by tick
 *
 * Give it a body (with response arrays), a device and, for the simulated device, a path; Start it,
 * Step it in virtual time, read what is felt. In virtual time nothing depends on the machine: the
 * same steps give the same bits.
 *
 * Body frame, mm and N, everywhere; the device works in SI units behind the workspace mapping,
 * which here keeps axes and scale (1 m = 1000 mm).
 *
 * Device "simulated", the only one of this version; other names are an error. In virtual time
 * (default) it is a stiff hand that follows SetPath, a polyline with a point array `Time` (s, not
 * decreasing). With RealTime, Start starts the servo thread at Rate, and the hand follows SteerTo,
 * as from a mouse. Then nothing is recorded, Step does nothing, and the getters give the newest
 * tick.
 *
 * What is wrong with the mesh of the body is said in one warning, as by vtkToolContactProbe.
 *
 * Not thread-safe: one thread steers, steps and reads; it never waits for the servo thread but in
 * Stop and Start.
 */
#ifndef vtkHapticSession_h
#define vtkHapticSession_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkPolyData;
class vtkTable;

namespace palpate
{
struct ContactBody;
struct ContactSettings;
struct ServoTick;
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
    Running = 1
  };

  ///@{
  /** The body with its response arrays; read at Start. */
  void SetBody(vtkPolyData* body);
  vtkPolyData* GetBody();
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /**
   * How the contact feels: properties, numbers, ranges and defaults of vtkToolContactProbe. Read at
   * Start, which fails with an error if one is out of its range.
   */
  vtkSetMacro(ForceForm, int);
  vtkGetMacro(ForceForm, int);
  vtkSetMacro(ContactSurface, int);
  vtkGetMacro(ContactSurface, int);
  vtkSetMacro(FrictionCoefficient, double);
  vtkGetMacro(FrictionCoefficient, double);
  vtkSetMacro(FrictionModel, int);
  vtkGetMacro(FrictionModel, int);
  vtkSetMacro(TangentialStiffness, double); // N/mm
  vtkGetMacro(TangentialStiffness, double);
  vtkSetMacro(FrictionBreakaway, double);
  vtkGetMacro(FrictionBreakaway, double);
  vtkSetMacro(FrictionStickRadius, double);
  vtkGetMacro(FrictionStickRadius, double);
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** Ticks per second, 1 to 100000. Default 1000. */
  vtkSetClampMacro(Rate, double, 1.0, 100000.0);
  vtkGetMacro(Rate, double);
  ///@}

  /** Chooses the device: "simulated". Returns false, after an error, for any other name. */
  bool SetDevice(const std::string& device);

  /** Path of the simulated device: a polyline in the body's frame with a point array `Time`. */
  void SetPath(vtkPolyData* path);

  ///@{
  /** Run on a servo thread instead of in virtual time; read at Start. Default off. */
  vtkSetMacro(RealTime, bool);
  vtkGetMacro(RealTime, bool);
  vtkBooleanMacro(RealTime, bool);
  ///@}

  /** With RealTime: where the hand is to go, mm, body frame. Before Start: where it begins. */
  void SteerTo(const double tip[3]);

  /** With RealTime: ticks made and ticks missed since Start. */
  vtkIdType GetNumberOfTicks() const;
  vtkIdType GetNumberOfMissedTicks() const;

  /** Reads body and path and begins at time 0. Returns false after an error that names the fault.
   */
  bool Start();
  void Stop();

  /** Runs all ticks due in the next `seconds` of virtual time; steps add up, whatever their length.
   * Nothing happens unless running, nor for times that are not positive and finite. */
  void Step(double seconds);

  int GetState() const;
  /** Virtual time, s, of the next tick. */
  double GetTime() const;
  /** Time of the path's last point, s; 0 before Start. */
  double GetPathDuration() const;

  ///@{
  /** The newest tick: tip, contact point, total force on the tool (before and after the limit of
   * the device), the friction in it, deflection, contact state as in vtkToolContactProbe. Zeros
   * before the first. */
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

  /** Every tick since Start, as one polyline of tips with the arrays of vtkToolContactProbe and
   * `Time`, `AppliedForce`. */
  void GetRecording(vtkPolyData* recording);

  /** One row: ticks, ticks in contact, peak force and friction (N), peak deflection (mm), median
   * and 99th percentile of the time per tick (ns, wall clock, so they differ from run to run). */
  void GetStatistics(vtkTable* statistics);

  /** Every tick since Start, for C++. */
  const std::vector<palpate::ServoTick>& GetTicks() const;

protected:
  vtkHapticSession();
  ~vtkHapticSession() override;

private:
  vtkHapticSession(const vtkHapticSession&) = delete;
  void operator=(const vtkHapticSession&) = delete;

  const palpate::ServoTick& Newest();

  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkPolyData> Path;
  std::string ResponseName = "Response";
  double Rate = 1000.0;

  int ForceForm = 1;
  int ContactSurface = 0;
  double FrictionCoefficient = 0.0;
  int FrictionModel = 0;
  double TangentialStiffness = 1.0;
  double FrictionBreakaway = 0.8;
  double FrictionStickRadius = 0.9;
  double PoissonRatio = 0.5;

  // Which state of which body was last found to be unsound.
  vtkPolyData* Unsound = nullptr;
  vtkMTimeType UnsoundTime = 0;

  std::shared_ptr<const palpate::ContactBody> ReadBody();
  bool ReadSettings(palpate::ContactSettings& settings);
  bool StartVirtual(
    std::shared_ptr<const palpate::ContactBody> kernel, const palpate::ContactSettings& settings);

  bool RealTime = false;
  double Steered[3] = { 0.0, 0.0, 0.0 };
  vtkIdType FirstPoly = 0;

  struct Loop;
  std::unique_ptr<Loop> Active; ///< in virtual time
  struct Thread;
  std::unique_ptr<Thread> Live; ///< in real time
};

#endif
