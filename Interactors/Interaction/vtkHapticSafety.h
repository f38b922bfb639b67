// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticSafety
 * @brief the limits of a vtkHapticSession's force before it reaches the hand
 *
 * Settings of the safety chain: its optional links, limits in addition to the limits of the device,
 * and the fit of all forces to the device. Three protections cannot be switched off: the limits of
 * the device, no force without a valid sample, and no force that is not finite.
 *
 * FitForce scales all forces by one factor. With this factor none of the compared responses exceeds
 * the device's maximum force and stiffness at any vertex down to FitDepth. The ratios of the forces
 * are unchanged, whereas a limit would make all large forces equal.
 *
 * The properties are read at the session's Start; the properties of the fit are also read at
 * ApplyChanges. Start and ApplyChanges fail with an error if a number is out of its range. Not
 * thread-safe.
 *
 * @code{.py}
 * safety = palpate.vtkHapticSafety()
 * safety.SetForceLimit(3.0)                            # N
 * safety.SetStiffnessLimit(1000.0)                     # N/m
 * safety.FitForceOn()
 * safety.SetFitDepth(1.0)                              # mm
 * session.SetSafety(safety)
 * @endcode
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
  /** Whether the force is zero until the tip has been outside of the body once. Default on. */
  vtkSetMacro(Gate, bool);
  vtkGetMacro(Gate, bool);
  vtkBooleanMacro(Gate, bool);
  ///@}
  ///@{
  /** Time over which the force of the first contact rises, s, >= 0. Default 0. */
  vtkSetMacro(EntryRamp, double);
  vtkGetMacro(EntryRamp, double);
  ///@}
  ///@{
  /**
   * Whether stiffness cap and passivity control act. They act only where the device's specification
   * requires them. Passivity control does not act on the stiff hand of "simulated" and
   * "replay:FILE". Default on.
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
   * Largest torque (N m) and torsional stiffness (N m/rad), for a device that outputs torque about
   * the tip. Default infinite. If TorqueLimit is 0, only the force is sent.
   */
  vtkSetMacro(TorqueLimit, double);
  vtkGetMacro(TorqueLimit, double);
  vtkSetMacro(TorsionalStiffnessLimit, double);
  vtkGetMacro(TorsionalStiffnessLimit, double);
  ///@}

  ///@{
  /** Whether forces are fitted to the device (see the description of the class). Default off: the
   * factor is 1. */
  vtkSetMacro(FitForce, bool);
  vtkGetMacro(FitForce, bool);
  vtkBooleanMacro(FitForce, bool);
  ///@}
  ///@{
  /** Depth down to which forces are fitted, mm, finite and > 0. Default 1. */
  vtkSetMacro(FitDepth, double);
  vtkGetMacro(FitDepth, double);
  ///@}
  ///@{
  /**
   * Prefixes of further responses that are compared, in addition to the session's own response.
   * Default none.
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
   * Returns the settings of the safety chain for a device. `isStiff` is whether the hand of the
   * device moves independently of the force.
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
