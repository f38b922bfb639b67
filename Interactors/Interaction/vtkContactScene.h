// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactScene
 * @brief a body under a tool, drawn into a renderer: dent, deflection field, tool, forces, legends
 *
 * Set a renderer, a body with responses and the tool. ShowTip shows one tip of the output of
 * vtkToolContactProbe or vtkHapticRecorder::GetRecording. ShowSession shows the newest tick of a
 * session. After Follow, ShowSession is called at each frame of a clock.
 *
 * - The body is displaced by the field of vtkContactDeflection, drawn to scale times Exaggeration.
 *   Its colour is the magnitude of the displacement, with a legend in mm.
 * - The tool is at the tip, with the force on it as an arrow and a number in N. With friction, the
 *   normal force and the friction are also shown. If the applied force differs from the ideal
 *   force, both are drawn next to each other (vtkHapticToolRepresentation).
 * - The contact circle has the radius a of the tool at the deflection, on a half-space or a layer.
 *   With a global compliance, a is the radius for the local part of the deflection.
 * - The trail is the path of the contact, coloured by the force at each point, with a legend in N.
 * - An arrow in the lower right corner, for a round number of newtons, is the scale of all arrows.
 * - ShowSession adapts this scale and the colours of the trail to the force. They grow at once if
 *   the force exceeds them. They shrink if for 3 s of contact all forces along the trail have been
 *   below a third of their end. For 3 s after a change the picture says "scale changed".
 * - A caption gives the tool, the deflection, the contact radius, the forces, the reasons for a
 *   different applied force, and the limit of validity. For a replayed record it names the setup of
 *   the record, or the differences from the present setup.
 *
 * For a session with several devices, the tools, arrows, circles and dents of all devices are
 * drawn, and the caption has a line for each device. Trail, camera and the values below are those
 * of the first device.
 *
 * Beyond the `Validity` of the response at the contact, arrows, circle and trail are dashed, and
 * the caption names the assumption that fails.
 *
 * @code{.py}
 * scene = palpate.vtkContactScene()
 * scene.SetRenderer(renderer)
 * scene.SetBody(body)                                  # with a response
 * scene.SetTool(tool)
 * scene.SetLargestForce(1.0)                           # N, for the scale of the arrows
 * scene.ShowTip(probe.GetOutput(), 0)
 * scene.LookAtBody((1, -0.5, 0.7), (0, 0, 1))
 * @endcode
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
class ScaleRule;
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

  /** The renderer. The scene adds its props to the renderer, sets its background, and arranges
   * legends and labels before each rendering. Call once. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();

  /** The body, with the responses of the probed tips. */
  void SetBody(vtkPolyData* body);
  void SetTool(vtkContactTool* tool);
  /** Poisson's ratio of the body, for the radial displacement. */
  void SetPoissonRatio(double ratio);
  ///@{
  /** Prefix of the response in contact, from which validity and displacement field are taken.
   * Default "Response". */
  void SetResponseName(const std::string& name);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  /** Range of the legend of the deflection field: 0 to `largest`, mm. Default 1. */
  void SetLargestDeflection(double largest);
  /**
   * Sets the force for which an arrow is about 40 mm long, N, and extends the colours of the trail
   * to this force. It must be finite and positive. Default 1. GetLargestForce returns the present
   * value, which ShowSession may have changed.
   */
  void SetLargestForce(double largest);
  vtkGetMacro(LargestForce, double);
  ///@{
  /** Factor by which the dent is drawn deeper than computed. The caption shows the factor. Default
   * 1. */
  void SetExaggeration(double factor);
  double GetExaggeration();
  ///@}
  ///@{
  /** Whether the vertex shader displaces the body. Its cost does not depend on the size of the
   * mesh. If off, vtkContactDeflection displaces the body point by point. Default on. */
  void SetDeflectionByShader(bool on);
  bool GetDeflectionByShader();
  ///@}
  /** First line of the caption. */
  void SetTitle(const std::string& title);

  /** Last line of the caption. It appears with the next shown contact. Default none. */
  void SetRemark(const std::string& remark);

  ///@{
  /** A line of the caption about the work in progress, above the remark. It appears with the next
   * shown tick of a session. Default none. */
  vtkSetMacro(Notice, std::string);
  vtkGetMacro(Notice, std::string);
  ///@}

  ///@{
  /** Whether the contact circle, and the trail with its legend, are drawn. A change takes effect
   * with the next shown contact. GetToolRepresentation controls the parts of the force. Default
   * on. */
  vtkSetMacro(ContactCircleVisibility, bool);
  vtkGetMacro(ContactCircleVisibility, bool);
  void SetTrailVisibility(bool visible);
  vtkGetMacro(TrailVisibility, bool);
  ///@}

  /**
   * Whether the scene is for a blind comparison. It then shows only the position of a contact as a
   * ball on the surface, regardless of the depth of the tip. Tool, forces, dent, circle, trail and
   * legends are not drawn. The caption has only title and remark. Default off.
   */
  void SetBlind(bool blind);

  /** Draws the contact points of a probe's output as the trail. Returns false if arrays of the
   * probe are missing. */
  bool ShowTrail(vtkPolyData* probed);
  ///@{
  /**
   * Length of the live trail, as the number of the last contacts of ShowSession, which are at least
   * 0.05 mm apart. With 0 there is no live trail. The default 600 corresponds to 20 s of motion at
   * 30 pictures per second. The live trail replaces a trail of ShowTrail. If the session's recorder
   * has a history (HistorySeconds), the trail also contains contacts from the time between two
   * pictures, at distances of 1 mm.
   */
  vtkSetClampMacro(TrailLength, int, 0, VTK_INT_MAX);
  vtkGetMacro(TrailLength, int);
  void ClearTrail();
  ///@}

  /** Shows the tip with index `index` of a probe's output. Returns false if arrays of the probe are
   * missing. Friction is drawn only if the array FrictionForce exists, the applied force only if
   * AppliedForce exists. */
  bool ShowTip(vtkPolyData* probed, vtkIdType index);

  /** Shows the newest tick of a session, with friction, applied force, the reasons for the applied
   * force, and the validity of the session's response at the contact. Adds the contact to the
   * trail. */
  void ShowSession(vtkHapticSession* session);
  /** Makes each frame of the clock call ShowSession, after the observers of default priority. A
   * null clock ends these calls. Follow must be called before the session's Start, because it
   * requests a history of at least 2 s. */
  void Follow(vtkFrameClock* clock, vtkHapticSession* session);
  ///@{
  /**
   * Direction of the tool while it has no contact. It need not have unit length. If it is zero, the
   * default, the last direction is kept. Each device has its own direction; `hand` is the index of
   * the device.
   */
  void SetFreeDirection(const double direction[3]) { this->SetFreeDirection(0, direction); }
  void SetFreeDirection(int hand, const double direction[3]);
  ///@}

  /**
   * Shows a contact that is given by numbers: position of the tip, contact point, unit normal,
   * force on the tool, deflection, and the cell of the body, which is -1 without contact.
   */
  void ShowContact(const double tip[3], const double contactPoint[3], const double normal[3],
    const double force[3], double deflection, vtkIdType cell);

  ///@{
  /**
   * Values of the shown contact. ContactRadius is the radius of its circle, mm, or 0 without a
   * circle. Validity is the depth to which the response is valid, mm; it is infinite if unknown.
   * The third value is whether the deflection is within that depth.
   */
  vtkGetMacro(ContactRadius, double);
  double GetValidity();
  bool IsValid();
  ///@}

  /**
   * Distance from the contact at which the deflection field ends, mm. With 0, the default, the
   * field ends where its validity ends.
   */
  void SetFieldRadius(double radius);

  ///@{
  /** Set the camera. LookAtBody shows the whole body with the tool, seen from `direction`.
   * LookAtContact shows the contact point of the last tick in contact, from the distance `distance`
   * (mm). Before the first such tick it shows the contact point that was drawn last. `up` is the
   * upward direction in the picture. */
  void LookAtBody(const double direction[3], const double up[3]);
  void LookAtContact(double distance, const double direction[3], const double up[3]);
  /** Restores the view of the last LookAtBody, including its direction. Without an earlier
   * LookAtBody, only the distance changes, so that everything is visible. */
  void ResetView();
  ///@}

  ///@{
  /** Parts of the scene. Use them to change their style. */
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
  void PassTicks(vtkHapticSession* session, double until);
  void FitForceScale(const palpate::ShownContact& contact);
  void Arrange();
  void ShowFrame();

  vtkSmartPointer<vtkRenderer> Renderer;
  unsigned long RenderObserver = 0;
  vtkSmartPointer<vtkPolyData> BodyData;
  std::string ResponseName = "Response";
  std::string Notice;
  vtkSmartPointer<vtkFrameClock> Clock;
  vtkSmartPointer<vtkHapticSession> Followed;
  unsigned long FrameObserver = 0;
  std::unique_ptr<palpate::SceneLegends> Legends;
  std::unique_ptr<palpate::BodyDisplay> Body;
  std::unique_ptr<palpate::ShownHands> Hands;
  std::unique_ptr<palpate::ForceTrail> Trail;
  std::unique_ptr<palpate::ForceScale> Scale;
  std::unique_ptr<palpate::SceneCaption> Caption;
  vtkSmartPointer<vtkActor> Marker; ///< drawn instead of the tool in a blind comparison
  bool Blind = false;
  bool ContactCircleVisibility = true;
  bool TrailVisibility = true;
  int TrailLength = 600;
  double LargestForce = 1.0;
  std::unique_ptr<palpate::ScaleRule> ForceRule;
  bool HasShownSession = false;
  bool IsScaleNew = false;          ///< whether the scale has changed since the last picture
  double ScaleTime = -1e30;         ///< session time of the last change of scale, s
  vtkIdType TrailRun = -1;          ///< number of the session's run to which TrailSeen refers
  unsigned long long TrailSeen = 0; ///< number of ticks that the trail has processed
  std::unique_ptr<palpate::ShownContact> Shown; ///< the contact that was shown last
  bool HasTouched = false;
  double ContactRadius = 0.0;
  double Contact[3] = { 0.0, 0.0, 0.0 }; ///< the point for LookAtContact
  bool HasBodyView = false;
  double BodyDirection[3] = { 0.0, 0.0, 1.0 }; ///< arguments of the last LookAtBody
  double BodyUp[3] = { 0.0, 1.0, 0.0 };
};

#endif
