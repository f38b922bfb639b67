// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactScene
 * @brief a body under a tool, drawn into a renderer: dent, deflection field, tool, force, legend
 *
 * Give it a renderer, a body with responses and the tool; ShowTip with the output of
 * vtkToolContactProbe (or vtkHapticSession::GetRecording) puts one tip on stage: the body is
 * displaced by the field of vtkContactDeflection, drawn to scale times Exaggeration, coloured by
 * its magnitude with a legend in mm; the tool stands at the tip with its force arrow; a caption
 * names tool, deflection, force and the scale of the arrow.
 *
 * The force scale is chosen once, by SetLargestForce, as a round number of mm per N, and stays.
 */
#ifndef vtkContactScene_h
#define vtkContactScene_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkActor;
class vtkContactDeflection;
class vtkContactTool;
class vtkHapticToolRepresentation;
class vtkLookupTable;
class vtkPolyData;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;
class vtkWarpVector;

class PALPATEINTERACTION_EXPORT vtkContactScene : public vtkObject
{
public:
  static vtkContactScene* New();
  vtkTypeMacro(vtkContactScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The renderer; the scene adds its props and sets the background. Call once. */
  void SetRenderer(vtkRenderer* renderer);

  /** The body, with the responses the tips were probed with. */
  void SetBody(vtkPolyData* body);
  void SetTool(vtkContactTool* tool);
  /** Poisson's ratio of the body, for the radial displacement. */
  void SetPoissonRatio(double ratio);

  /** Legend of the deflection field: 0 to `largest` mm. Default 1. */
  void SetLargestDeflection(double largest);
  /** Makes the arrow of a force of `largest` N about 40 mm long. Default 1. */
  void SetLargestForce(double largest);
  ///@{
  /** The dent is drawn this many times deeper than it is; said in the caption. Default 1. */
  void SetExaggeration(double factor);
  double GetExaggeration();
  ///@}
  /** First line of the caption. */
  void SetTitle(const std::string& title);

  /** Last line of the caption, from the next contact shown on. Default none. */
  void SetRemark(const std::string& remark);

  /**
   * For a blind comparison: of a contact only its place is shown, by a ball, which rests on the
   * surface however deep the tip is. No tool, force, dent, legend; the caption is title and remark.
   * Default off.
   */
  void SetBlind(bool blind);

  /** Draws the contact points of a probe's output as a line: the way the tool goes. */
  bool ShowTrail(vtkPolyData* probed);

  /** Shows tip `index` of a probe's output; returns false if the probe's arrays are missing. */
  bool ShowTip(vtkPolyData* probed, vtkIdType index);

  /**
   * Shows a contact given by numbers (a live session): tip, contact point, unit normal and force on
   * the tool, deflection, and the cell of the body (-1: no contact).
   */
  void ShowContact(const double tip[3], const double contactPoint[3], const double normal[3],
    const double force[3], double deflection, vtkIdType cell);

  /** The deflection field ends at this distance from the contact, mm; 0 (default): where validity
   * ends. Live sessions set it, since the cost of a frame grows with the field. */
  void SetFieldRadius(double radius);

  ///@{
  /** Camera: the whole body with the tool seen from `direction`; or the contact from `distance` mm,
   * from `direction`. `up` points up in the picture. */
  void LookAtBody(const double direction[3], const double up[3]);
  void LookAtContact(double distance, const double direction[3], const double up[3]);
  ///@}

  ///@{
  /** The parts, to restyle them. */
  vtkHapticToolRepresentation* GetToolRepresentation();
  vtkActor* GetBodyActor();
  vtkScalarBarActor* GetLegend();
  ///@}

protected:
  vtkContactScene();
  ~vtkContactScene() override;

private:
  vtkContactScene(const vtkContactScene&) = delete;
  void operator=(const vtkContactScene&) = delete;

  double GetLegendShare(); ///< of the width of the viewport
  void PlaceLegend();
  void DescribeContact(double deflection, double force);
  void WriteCaption(const std::string& contact);

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkPolyData> Tip; ///< the contact shown, as a probe's output
  vtkSmartPointer<vtkContactDeflection> Deflection;
  vtkSmartPointer<vtkWarpVector> Warp;
  vtkSmartPointer<vtkActor> BodyActor;
  vtkSmartPointer<vtkActor> TrailActor;
  vtkSmartPointer<vtkLookupTable> Colors;
  vtkSmartPointer<vtkScalarBarActor> Legend;
  vtkSmartPointer<vtkTextActor> Caption;
  vtkSmartPointer<vtkHapticToolRepresentation> ToolRepresentation;
  vtkSmartPointer<vtkActor> Marker; ///< of a contact that is shown blind
  bool Blind = false;
  std::string Title;
  std::string Remark;
  double Contact[3] = { 0.0, 0.0, 0.0 };
};

#endif
