// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHapticToolRepresentation
 * @brief the tool at its contact, and the forces on it as arrows with their values
 *
 * The tool is drawn at its tip along the contact normal, or along its own axis if that is known.
 * The tool is translucent, so that it hides neither dent nor arrow. The arrow of the total ideal
 * force starts at the contact point and is ForceScale mm long per newton. The label at its head is
 * the magnitude in newtons. Without force there is no arrow.
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
 * as long as the viewport has a free place.
 *
 * A torque about the tip is drawn as an arc in the direction of rotation, with its value in N mm.
 * It is drawn if it is at least 2 % of the torque that the contact force would have with the arc's
 * radius as lever arm. The length of the arc is the length of an arrow for a force that has the
 * same torque at the arc's radius.
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
  /**
   * ComponentsVisibility: whether normal force and friction are drawn if there is friction.
   * AppliedForceVisibility: whether the applied force is drawn if it differs from the ideal force.
   * A change takes effect with the next contact. Default on.
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
   * arrow, and the force on the tool (N). If the normal is zero, the direction does not change.
   */
  void SetContact(const double tip[3], const double normal[3], const double contactPoint[3],
    const double force[3]);
  /**
   * As above, with the friction that is part of the force, and the applied force. Without a device,
   * or if the forces are equal, pass `force` as `applied`.
   */
  void SetContact(const double tip[3], const double normal[3], const double contactPoint[3],
    const double force[3], const double friction[3], const double applied[3]);

  /**
   * Sets, for the next contacts, the axis of the tool (from its tip up the shaft) and the torque on
   * the tool about its tip, N mm. Zeros (default): the axis is unknown, and there is no torque.
   */
  void SetTilt(const double axis[3], const double torque[3]);

  /**
   * Sets another representation that is drawn before this one. Its labels are placed first, and the
   * labels of this representation avoid them. Default none.
   */
  void SetLabelsAfter(vtkHapticToolRepresentation* other);

#ifndef __VTK_WRAP__
  /** Further parts of the scene that the labels leave free. */
  void LeaveFree(std::vector<palpate::LabelObstacle> obstacles);
#endif

  ///@{
  /**
   * Radius of the circle around the contact point that labels must not cover, mm; 0 (default): no
   * circle.
   */
  vtkSetMacro(ContactRadius, double);
  vtkGetMacro(ContactRadius, double);
  ///@}

  ///@{
  /**
   * Whether a label stays at its place relative to its arrow unless another place is clearly
   * better. Then labels do not jump in a live picture. Off (default): a picture does not depend on
   * the previous pictures.
   */
  vtkSetMacro(SteadyLabels, bool);
  vtkGetMacro(SteadyLabels, bool);
  ///@}

  ///@{
  /** Overridden, because the places of the applied force and of the labels depend on the camera. */
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
  double Axis[3] = { 0.0, 0.0, 1.0 };    ///< direction along which the tool stands
  double OwnAxis[3] = { 0.0, 0.0, 0.0 }; ///< axis of the tool, if it is known
  double TorqueAboutTip[3] = { 0.0, 0.0, 0.0 };
  double ContactPoint[3] = { 0.0, 0.0, 0.0 }; ///< start of the arrows
};

#endif
