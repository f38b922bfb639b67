// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticToolRepresentation
 * @brief the tool at its contact, and the forces on it as arrows with their values
 *
 * The tool is drawn at its tip along the contact normal, or along its own axis if that is known.
 * The tool is translucent, so that it hides neither dent nor arrow. The arrow of the total ideal
 * force starts at the contact point and is ForceScale mm long per newton. The label at its head is
 * the magnitude in newtons. If the force is zero, there is no arrow.
 *
 * If the friction is at least 2 % of the force, two thinner arrows from the same point show the
 * normal force and the friction. If the applied force (after the safety chain) differs from the
 * ideal force by more than 2 %, the applied force is drawn to the right of the ideal force as seen
 * by the camera, at the same scale.
 *
 * An arrow within 20 degrees of the line of sight gets a ring at its head, with a dot if the arrow
 * points towards the viewer and a cross if it points away. The diameter of the ring is the length
 * of the arrow.
 *
 * Labels stay inside the viewport. They do not cover one another, arrows, tool or contact circle,
 * as long as the viewport has free space.
 *
 * A torque about the tip is drawn as an arc in the direction of rotation, with its value in N mm.
 * The arc is drawn if the torque is at least 2 % of the torque of the contact force with the arc's
 * radius as lever arm. The length of the arc is that of an arrow for the force that causes the same
 * torque with this lever arm.
 *
 * BeyondValidity draws the arrows dashed.
 *
 * Lengths in mm and forces in N, in the body's frame.
 *
 * @code{.py}
 * shown = palpate.vtkHapticToolRepresentation()
 * shown.SetTool(tool)
 * shown.SetForceScale(20)                              # mm per N
 * shown.SetContact((0, 0, 49), (0, 0, 1), (0, 0, 50), (0, 0, 0.5))  # tip, normal, place, force
 * renderer.AddViewProp(shown)
 * @endcode
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
class EndOnSign;
class ForceArrow;
class TorqueArc;
struct AnchoredLabel;
struct LabelObstacle;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkHapticToolRepresentation : public vtkPropAssembly
{
public:
  static vtkHapticToolRepresentation* New();
  vtkTypeMacro(vtkHapticToolRepresentation, vtkPropAssembly);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tool to draw. Required before the first rendering. */
  void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** Length of the arrow per force, mm/N, > 0. Default 10. */
  vtkSetMacro(ForceScale, double);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /** Length of the drawn tool, mm, > 0. Default 22. */
  void SetToolLength(double length);
  double GetToolLength();
  ///@}

  ///@{
  /**
   * ComponentsVisibility is whether normal force and friction are drawn if there is friction.
   * AppliedForceVisibility is whether the applied force is drawn if it differs from the ideal
   * force. A change takes effect with the next contact. Default on.
   */
  vtkSetMacro(ComponentsVisibility, bool);
  vtkGetMacro(ComponentsVisibility, bool);
  vtkSetMacro(AppliedForceVisibility, bool);
  vtkGetMacro(AppliedForceVisibility, bool);
  ///@}

  ///@{
  /**
   * Whether the arrows are dashed, because the force is beyond the validity of its law. A change
   * takes effect with the next contact. Default off.
   */
  vtkSetMacro(BeyondValidity, bool);
  vtkGetMacro(BeyondValidity, bool);
  ///@}

  /**
   * Sets the tip of the tool, the outward normal along which the tool is drawn, the start of the
   * arrow, and the force on the tool (N). If the normal is zero, the direction of the tool does not
   * change.
   */
  void SetContact(const double tip[3], const double normal[3], const double contactPoint[3],
    const double force[3]);
  /**
   * Sets the same quantities, and also the friction, which is part of the force, and the applied
   * force. Without a device, or if the forces are equal, pass `force` as `applied`.
   */
  void SetContact(const double tip[3], const double normal[3], const double contactPoint[3],
    const double force[3], const double friction[3], const double applied[3]);

  /**
   * Sets the axis of the tool, from its tip towards the hand, and the torque on the tool about its
   * tip, N mm, for the next contacts. A zero axis means that the axis is unknown, a zero torque
   * that there is none. Default: both zero.
   */
  void SetTilt(const double axis[3], const double torque[3]);

  /**
   * Sets another representation that is drawn before this one. Its labels are placed first, and the
   * labels of this representation avoid the labels of the other. Default none.
   */
  void SetLabelsAfter(vtkHapticToolRepresentation* other);

#ifndef __VTK_WRAP__
  /** Sets further parts of the scene that the labels must not cover. */
  void LeaveFree(std::vector<palpate::LabelObstacle> obstacles);
#endif

  ///@{
  /**
   * Radius of the circle around the contact point that labels must not cover, mm. With 0, the
   * default, there is no circle.
   */
  vtkSetMacro(ContactRadius, double);
  vtkGetMacro(ContactRadius, double);
  ///@}

  ///@{
  /**
   * Whether a label keeps its position relative to its arrow unless another position is clearly
   * better, so that labels do not jump in a live picture. If off, a picture does not depend on the
   * previous pictures. Default off.
   */
  vtkSetMacro(SteadyLabels, bool);
  vtkGetMacro(SteadyLabels, bool);
  ///@}

  ///@{
  /** Overridden because the positions of the applied force and of the labels depend on the
   * camera. */
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
  void CollectTool(std::vector<palpate::LabelObstacle>& obstacles);
  void CollectObstacles(std::vector<palpate::LabelObstacle>& obstacles);

  vtkSmartPointer<vtkContactToolSource> Source;
  vtkSmartPointer<vtkActor> ToolActor;
  std::unique_ptr<palpate::ForceArrow> Total;
  std::unique_ptr<palpate::ForceArrow> NormalPart;
  std::unique_ptr<palpate::ForceArrow> Friction;
  std::unique_ptr<palpate::ForceArrow> Applied;
  std::unique_ptr<palpate::TorqueArc> Torque;
  std::unique_ptr<palpate::EndOnSign> TotalSign;
  std::unique_ptr<palpate::EndOnSign> AppliedSign;
  vtkWeakPointer<vtkHapticToolRepresentation> LabelsAfter;
  double ForceScale = 10.0;
  bool ComponentsVisibility = true;
  bool AppliedForceVisibility = true;
  bool BeyondValidity = false;
  bool SteadyLabels = false;
  double ContactRadius = 0.0;
  std::vector<palpate::LabelObstacle> LeftFree;
  double Axis[3] = { 0.0, 0.0, 1.0 };    ///< direction along which the tool is drawn
  double OwnAxis[3] = { 0.0, 0.0, 0.0 }; ///< axis of the tool, if it is known
  double TorqueAboutTip[3] = { 0.0, 0.0, 0.0 };
  double ContactPoint[3] = { 0.0, 0.0, 0.0 }; ///< start of the arrows
};

#endif
