// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticSafety
 * @brief what a force of a vtkHapticSession must keep to before it reaches the hand
 *
 * The links of the safety chain that may be chosen, limits beside those the device states, and the
 * fit of all forces to the device. That nothing is sent for what is not finite or not heard of, and
 * the device's own limits, are not to be chosen.
 *
 * FitForce: all forces are scaled by one factor, such that down to FitDepth none of the responses
 * compared, at any vertex, exceeds the force and the stiffness that the device is good for. What is
 * compared keeps its ratios then, which limits would level.
 *
 * Read at the session's Start, the fit also at its ApplyChanges, which fail with an error if a
 * number is out of its range. For one thread.
 */
#ifndef vtkHapticSafety_h
#define vtkHapticSafety_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <limits> // For std::numeric_limits
#include <string> // For std::string
#include <vector> // For std::vector

namespace palpate
{
struct DeviceSpecification;
struct SafetySettings;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkHapticSafety : public vtkObject
{
public:
  static vtkHapticSafety* New();
  vtkTypeMacro(vtkHapticSafety, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** No force until the tip has been outside once. Default on. */
  vtkSetMacro(Gate, bool);
  vtkGetMacro(Gate, bool);
  vtkBooleanMacro(Gate, bool);
  ///@}
  ///@{
  /** Seconds over which the force of the first touch rises, >= 0. Default 0. */
  vtkSetMacro(EntryRamp, double);
  vtkGetMacro(EntryRamp, double);
  ///@}
  ///@{
  /** As far as the device says it needs them. Default on; passivity is never controlled through the
   * stiff hand of "simulated" and "replay:FILE". */
  vtkSetMacro(StiffnessCap, bool);
  vtkGetMacro(StiffnessCap, bool);
  vtkBooleanMacro(StiffnessCap, bool);
  vtkSetMacro(PassivityControl, bool);
  vtkGetMacro(PassivityControl, bool);
  vtkBooleanMacro(PassivityControl, bool);
  ///@}
  ///@{
  /** Beside what the device says of itself: no more force (N) and stiffness (N/m) than this.
   * Default infinite. */
  vtkSetMacro(ForceLimit, double);
  vtkGetMacro(ForceLimit, double);
  vtkSetMacro(StiffnessLimit, double);
  vtkGetMacro(StiffnessLimit, double);
  ///@}
  ///@{
  /** The same of a device that outputs torque, about the tip: N m and N m/rad. Default infinite;
   * with a TorqueLimit of 0 it gets its force alone. */
  vtkSetMacro(TorqueLimit, double);
  vtkGetMacro(TorqueLimit, double);
  vtkSetMacro(TorsionalStiffnessLimit, double);
  vtkGetMacro(TorsionalStiffnessLimit, double);
  ///@}

  ///@{
  /** Whether forces are fitted to the device, see above. Default off: the factor is 1. */
  vtkSetMacro(FitForce, bool);
  vtkGetMacro(FitForce, bool);
  vtkBooleanMacro(FitForce, bool);
  ///@}
  ///@{
  /** The depth down to which forces are fitted, mm, finite and > 0. Default 1. */
  vtkSetMacro(FitDepth, double);
  vtkGetMacro(FitDepth, double);
  ///@}
  ///@{
  /** Prefixes of the responses that are compared, beside the session's own. Default none. */
  void AddFitResponse(const std::string& responseName);
  void ClearFitResponses();
  ///@}

#ifndef __VTK_WRAP__
  const std::vector<std::string>& GetFitResponses() const
  {
    return this->FitResponses;
  }
  /** What the chain is told for such a device; `isStiff`: its hand goes its way whatever it feels.
   */
  palpate::SafetySettings GetSettings(
    const palpate::DeviceSpecification& device, bool isStiff) const;
#endif

protected:
  vtkHapticSafety();
  ~vtkHapticSafety() override;

private:
  vtkHapticSafety(const vtkHapticSafety&) = delete;
  void operator=(const vtkHapticSafety&) = delete;

  bool Gate = true;
  double EntryRamp = 0.0;
  bool StiffnessCap = true;
  bool PassivityControl = true;
  double ForceLimit = std::numeric_limits<double>::infinity();
  double StiffnessLimit = std::numeric_limits<double>::infinity();
  double TorqueLimit = std::numeric_limits<double>::infinity();
  double TorsionalStiffnessLimit = std::numeric_limits<double>::infinity();
  bool FitForce = false;
  double FitDepth = 1.0;
  std::vector<std::string> FitResponses;
};

#endif
