// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticToolRepresentation
 * @brief the tool where it touches, and the forces on it as arrows with their values
 *
 * The tool stands on its tip along the contact normal, or its own axis where that is known,
 * translucent, so that neither the dent nor
 * the arrow hides in it. The arrow of the total, ideal force starts at the contact point, is
 * ForceScale mm long per newton, and carries the magnitude in newtons at its head. Without force
 * there is no arrow.
 *
 * Where there is friction, of at least 2 % of the force, two thinner arrows from the same point
 * show the parts of the force, normal and friction. Where the applied force (what a device is told,
 * behind its safety chain) differs from the ideal one by more than 2 %, it is drawn beside it, to
 * the right as seen by the camera, at the same scale. Labels do not cover one another.
 *
 * A torque about the tip, of at least 2 % of what the force would do at the arc's radius, is an arc
 * the way it turns, with its N mm: as long as the arrow of the force that does the same there.
 *
 * BeyondValidity dashes the arrows.
 *
 * Body frame; mm and N.
 */
#ifndef vtkHapticToolRepresentation_h
#define vtkHapticToolRepresentation_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkPropAssembly.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer
#include "vtkWeakPointer.h"  // For vtkWeakPointer

#include <memory> // For std::unique_ptr
#include <vector> // For std::vector

class vtkActor;
class vtkContactTool;
class vtkContactToolSource;

namespace palpate
{
class ForceArrow;
class TorqueArc;
struct AnchoredLabel;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkHapticToolRepresentation : public vtkPropAssembly
{
public:
  static vtkHapticToolRepresentation* New();
  vtkTypeMacro(vtkHapticToolRepresentation, vtkPropAssembly);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tool drawn; required before the first rendering. */
  void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** Length of the arrow, mm per N, > 0. Default 10. */
  vtkSetMacro(ForceScale, double);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /** Length of the drawn tool, mm, > 0. Default 22. */
  void SetToolLength(double length);
  double GetToolLength();
  ///@}

  ///@{
  /** Whether normal force and friction are drawn, where there is friction; whether the applied
   * force, where it differs. From the next contact on. Default on. */
  vtkSetMacro(ComponentsVisibility, bool);
  vtkGetMacro(ComponentsVisibility, bool);
  vtkSetMacro(AppliedForceVisibility, bool);
  vtkGetMacro(AppliedForceVisibility, bool);
  ///@}

  ///@{
  /** Whether the arrows are dashed: the force is beyond what its law is valid for. From the next
   * contact on. Default off. */
  vtkSetMacro(BeyondValidity, bool);
  vtkGetMacro(BeyondValidity, bool);
  ///@}

  /**
   * Places the tool: its tip, the outward normal it stands along, where the arrow starts, and the
   * force on it (N). A zero normal leaves the direction as it was.
   */
  void SetContact(const double tip[3], const double normal[3], const double contactPoint[3],
    const double force[3]);
  /** The same with the friction that is part of the force, and what the device applies instead of
   * the force (the force itself where it applies that, or where there is no device). */
  void SetContact(const double tip[3], const double normal[3], const double contactPoint[3],
    const double force[3], const double friction[3], const double applied[3]);

  /**
   * From the next contact on: the tool's axis, from its tip up the shaft, and the torque on it
   * about the tip, N mm. Zeros: the axis is not known, and there is no torque. Default.
   */
  void SetTilt(const double axis[3], const double torque[3]);

  /** Another one, drawn before, whose labels are placed first: those of this one make way for them.
   * Default none. */
  void SetLabelsAfter(vtkHapticToolRepresentation* other);

  ///@{
  /** Reimplemented: what depends on the camera, place of the applied force and of the labels. */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  ///@}

protected:
  vtkHapticToolRepresentation();
  ~vtkHapticToolRepresentation() override;

private:
  vtkHapticToolRepresentation(const vtkHapticToolRepresentation&) = delete;
  void operator=(const vtkHapticToolRepresentation&) = delete;

  void CollectLabels(std::vector<palpate::AnchoredLabel>& labels);

  vtkSmartPointer<vtkContactToolSource> Source;
  vtkSmartPointer<vtkActor> ToolActor;
  std::unique_ptr<palpate::ForceArrow> Total;
  std::unique_ptr<palpate::ForceArrow> NormalPart;
  std::unique_ptr<palpate::ForceArrow> Friction;
  std::unique_ptr<palpate::ForceArrow> Applied;
  std::unique_ptr<palpate::TorqueArc> Torque;
  vtkWeakPointer<vtkHapticToolRepresentation> LabelsAfter;
  double ForceScale = 10.0;
  bool ComponentsVisibility = true;
  bool AppliedForceVisibility = true;
  bool BeyondValidity = false;
  double Axis[3] = { 0.0, 0.0, 1.0 };    ///< the tool stands along it
  double OwnAxis[3] = { 0.0, 0.0, 0.0 }; ///< of the tool, if it is known
  double TorqueAboutTip[3] = { 0.0, 0.0, 0.0 };
  double ContactPoint[3] = { 0.0, 0.0, 0.0 }; ///< where the arrows start
};

#endif
