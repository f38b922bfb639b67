// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactScene
 * @brief a body under a tool, drawn into a renderer: dent, deflection field, tool, forces, legends
 *
 * Give it a renderer, a body with responses and the tool. ShowTip shows one tip of
 * vtkToolContactProbe's output (or vtkHapticRecorder::GetRecording), ShowSession the newest tick of
 * a session, and Follow the latter at each frame of a clock.
 *
 * - The body is displaced by the field of vtkContactDeflection, drawn to scale times Exaggeration,
 *   coloured by its magnitude with a legend in mm.
 * - The tool at the tip, with the force on it as an arrow and a number in N; with friction also its
 *   parts, normal and friction; and the applied force beside it, if it differs from the ideal one
 *   (vtkHapticToolRepresentation).
 * - The contact circle: radius a of the tool at the deflection, on half-space or layer; of a global
 *   compliance at the local part alone.
 * - The trail: the path of the contact, coloured by the force there, with a legend in N.
 * - An arrow of a round number of newtons in the lower right corner is the scale of all arrows; it
 *   is chosen once, by SetLargestForce.
 * - A caption with tool, deflection, contact radius, forces, why the applied force differs, and
 *   what limits the validity.
 *
 * Of a session with several devices the tools, arrows, circles and dents of all are drawn, and the
 * caption has a line for each; trail, camera and the values below are those of the first.
 *
 * Beyond the `Validity` of the response at the contact, arrows, circle and trail are dashed, and
 * the caption names the assumption that breaks.
 */
#ifndef vtkContactScene_h
#define vtkContactScene_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkActor;
class vtkContactTool;
class vtkFrameClock;
class vtkHapticSession;
class vtkHapticToolRepresentation;
class vtkPolyData;
class vtkRenderer;
class vtkScalarBarActor;

namespace palpate
{
class BodyDisplay;
class ForceScale;
class ForceTrail;
class SceneCaption;
class SceneLegends;
struct ShownContact;
class ShownHands;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkContactScene : public vtkObject
{
public:
  static vtkContactScene* New();
  vtkTypeMacro(vtkContactScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The renderer; the scene adds its props, sets the background and arranges legends and labels
   * whenever it renders. Call once. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();

  /** The body, with the responses of the probed tips. */
  void SetBody(vtkPolyData* body);
  void SetTool(vtkContactTool* tool);
  /** Poisson's ratio of the body, for the radial displacement. */
  void SetPoissonRatio(double ratio);
  ///@{
  /** Prefix of the response that is touched, for its validity and its field. Default "Response". */
  void SetResponseName(const std::string& name);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  /** Legend of the deflection field: 0 to `largest` mm. Default 1. */
  void SetLargestDeflection(double largest);
  /**
   * Makes the arrow of a force of `largest` N about 40 mm long, and sets the range of the trail's
   * colours to it. Default 1.
   */
  void SetLargestForce(double largest);
  ///@{
  /** Factor by which the dent is drawn deeper; shown in the caption. Default 1. */
  void SetExaggeration(double factor);
  double GetExaggeration();
  ///@}
  ///@{
  /** On (default): the vertex shader displaces the body, at a cost that does not grow with the
   * mesh. Off: vtkContactDeflection does, point by point. */
  void SetDeflectionByShader(bool on);
  bool GetDeflectionByShader();
  ///@}
  /** First line of the caption. */
  void SetTitle(const std::string& title);

  /** Last line of the caption, from the next contact shown on. Default none. */
  void SetRemark(const std::string& remark);

  ///@{
  /** Which parts are drawn, from the next contact shown on: the circle of contact, the trail with
   * its legend; for those of the force see GetToolRepresentation. Default on. */
  vtkSetMacro(ContactCircleVisibility, bool);
  vtkGetMacro(ContactCircleVisibility, bool);
  void SetTrailVisibility(bool visible);
  vtkGetMacro(TrailVisibility, bool);
  ///@}

  /**
   * For a blind comparison: only the place of a contact is shown, by a ball on the surface,
   * whatever the depth of the tip. No tool, force, dent, circle, trail, legend; the caption is
   * title and remark. Default off.
   */
  void SetBlind(bool blind);

  /** Draws the contact points of a probe's output as the trail. */
  bool ShowTrail(vtkPolyData* probed);
  ///@{
  /**
   * The live trail: number of the last contacts of ShowSession, at least 0.05 mm apart; 0 for none.
   * Default 600: 20 s of motion at 30 pictures per second. It replaces a trail of ShowTrail.
   */
  vtkSetClampMacro(TrailLength, int, 0, VTK_INT_MAX);
  vtkGetMacro(TrailLength, int);
  void ClearTrail();
  ///@}

  /** Shows tip `index` of a probe's output; returns false if the probe's arrays are missing.
   * Without an array FrictionForce or AppliedForce there is no friction, or no applied force. */
  bool ShowTip(vtkPolyData* probed, vtkIdType index);

  /** Shows the newest tick of a session, with friction, applied force, its reasons and the validity
   * of the session's response at the contact, and adds it to the trail. */
  void ShowSession(vtkHapticSession* session);
  /** The same at each frame of the clock, after observers without priority; null: no longer. */
  void Follow(vtkFrameClock* clock, vtkHapticSession* session);
  ///@{
  /**
   * Direction of the tool, of any length, without contact; zero (default): the last one. For
   * another device by its index, once it is shown.
   */
  void SetFreeDirection(const double direction[3]) { this->SetFreeDirection(0, direction); }
  void SetFreeDirection(int hand, const double direction[3]);
  ///@}

  /**
   * Shows a contact given by numbers: tip, contact point, unit normal and force on the tool,
   * deflection, and the cell of the body (-1: no contact).
   */
  void ShowContact(const double tip[3], const double contactPoint[3], const double normal[3],
    const double force[3], double deflection, vtkIdType cell);

  ///@{
  /**
   * Of the contact shown: radius of its circle, mm (0: none); the depth to which its response is
   * valid, mm (infinite: unknown); and whether the deflection is within it.
   */
  vtkGetMacro(ContactRadius, double);
  double GetValidity();
  bool IsValid();
  ///@}

  /**
   * Distance from the contact at which the deflection field ends, mm; 0 (default): where its
   * validity ends.
   */
  void SetFieldRadius(double radius);

  ///@{
  /** Camera: the whole body with the tool seen from `direction`; or from `distance` mm the last
   * contact that touched (before the first: the contact point last shown). `up` points up in the
   * picture. */
  void LookAtBody(const double direction[3], const double up[3]);
  void LookAtContact(double distance, const double direction[3], const double up[3]);
  ///@}

  ///@{
  /** The parts, to restyle them. */
  vtkHapticToolRepresentation* GetToolRepresentation();
  vtkActor* GetBodyActor();
  vtkActor* GetTrailActor();
  vtkActor* GetCircleActor();
  vtkScalarBarActor* GetLegend();
  vtkScalarBarActor* GetTrailLegend();
  ///@}

protected:
  vtkContactScene();
  ~vtkContactScene() override;

private:
  vtkContactScene(const vtkContactScene&) = delete;
  void operator=(const vtkContactScene&) = delete;

  void Show(const std::vector<palpate::ShownContact>& contacts);
  void ShowBlind(const palpate::ShownContact& contact);
  void SwitchTrail();
  void Arrange();
  void ShowFrame();

  vtkSmartPointer<vtkRenderer> Renderer;
  unsigned long RenderObserver = 0;
  vtkSmartPointer<vtkPolyData> BodyData;
  std::string ResponseName = "Response";
  vtkSmartPointer<vtkFrameClock> Clock;
  vtkSmartPointer<vtkHapticSession> Followed;
  unsigned long FrameObserver = 0;
  std::unique_ptr<palpate::SceneLegends> Legends;
  std::unique_ptr<palpate::BodyDisplay> Body;
  std::unique_ptr<palpate::ShownHands> Hands;
  std::unique_ptr<palpate::ForceTrail> Trail;
  std::unique_ptr<palpate::ForceScale> Scale;
  std::unique_ptr<palpate::SceneCaption> Caption;
  vtkSmartPointer<vtkActor> Marker; ///< of a contact in a blind comparison
  bool Blind = false;
  bool ContactCircleVisibility = true;
  bool TrailVisibility = true;
  int TrailLength = 600;
  std::unique_ptr<palpate::ShownContact> Shown; ///< the contact last shown
  bool HasTouched = false;
  double ContactRadius = 0.0;
  double Contact[3] = { 0.0, 0.0, 0.0 }; ///< what LookAtContact looks at
};

#endif
