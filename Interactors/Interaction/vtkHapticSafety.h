// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticSafety
 * @brief the limits of a vtkHapticSession's force before it reaches the hand
 *
 * The optional links of the safety chain, limits in addition to those of the device, and the fit of
 * all forces to the device. The device's own limits, and that nothing is sent without a valid
 * sample or for a force that is not finite, cannot be switched off.
 *
 * FitForce: all forces are scaled by one factor, such that down to FitDepth none of the responses
 * compared, at any vertex, exceeds the device's maximum force and stiffness. Their ratios are then
 * kept, which limits would level.
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
  /** Seconds over which the force of the first contact rises, >= 0. Default 0. */
  vtkSetMacro(EntryRamp, double);
  vtkGetMacro(EntryRamp, double);
  ///@}
  ///@{
  /**
   * Active as far as the device's specification requires. Default on; passivity is never controlled
   * through the stiff hand of "simulated" and "replay:FILE".
   */
  vtkSetMacro(StiffnessCap, bool);
  vtkGetMacro(StiffnessCap, bool);
  vtkBooleanMacro(StiffnessCap, bool);
  vtkSetMacro(PassivityControl, bool);
  vtkGetMacro(PassivityControl, bool);
  vtkBooleanMacro(PassivityControl, bool);
  ///@}
  ///@{
  /**
   * Largest force (N) and stiffness (N/m), in addition to the device's specification. Default
   * infinite.
   */
  vtkSetMacro(ForceLimit, double);
  vtkGetMacro(ForceLimit, double);
  vtkSetMacro(StiffnessLimit, double);
  vtkGetMacro(StiffnessLimit, double);
  ///@}
  ///@{
  /**
   * The same for a device that outputs torque, about the tip: N m and N m/rad. Default infinite;
   * with a TorqueLimit of 0 only the force is sent.
   */
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
  /**
   * Prefixes of the responses that are compared, in addition to the session's own. Default none.
   */
  void AddFitResponse(const std::string& responseName);
  void ClearFitResponses();
  ///@}

#ifndef __VTK_WRAP__
  const std::vector<std::string>& GetFitResponses() const
  {
    return this->FitResponses;
  }
  /**
   * The settings of the chain for such a device; `isStiff`: its hand moves independently of the
   * force.
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
