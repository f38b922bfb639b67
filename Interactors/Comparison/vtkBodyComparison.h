// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkBodyComparison
 * @brief two bodies side by side under the same tools and motion: does the shape of the tool
 * matter?
 *
 * The question of Mahvash and Hayward (2002), section 2: on a body that deforms globally all tools
 * have the same force, on one that deforms locally they do not.
 *
 * Give it a window, two bodies that carry responses of the same tools under the same names, and the
 * tools. Each half of the window shows, from top to bottom, the body under the shown tool
 * (vtkContactScene), force over deflection of all tools at the point of contact (vtkResponseChart,
 * dotted beyond validity) with the running point of the shown one, and the verdict in words: λ and
 * tool sensitivity (vtkContactRegime) at Deflection, the spread of the forces, the depths for which
 * the verdict holds and the depth to which the responses are valid. The verdict is the most
 * cautious of those of the tools. Both bodies share one camera; axes and force arrows have separate
 * scales, since forces may differ a hundredfold.
 *
 * The bodies are of one material (YoungsModulus, PoissonRatio); their support and layers are given
 * by the point arrays `GlobalCompliance` (mm/N) and `LayerThickness` (mm), if present. Material and
 * responses must agree, otherwise an error says where they do not.
 *
 * ShowTips moves both scenes to one tip each, of vtkToolContactProbe or a recording; ShowSessions
 * to the newest tick of two sessions. Curves and verdict follow the contact from vertex to vertex;
 * one change takes some milliseconds. Color chooses the colours of the bodies: the displacement, or
 * one of the maps of vtkRegimeMap, which take some seconds per million points when first shown.
 *
 * Errors: vtkErrorMacro, and false.
 *
 * @sa vtkContactScene vtkContactRegime vtkRegimeMap
 */
#ifndef vtkBodyComparison_h
#define vtkBodyComparison_h

#include "palpateComparisonModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkContactScene;
class vtkContactTool;
class vtkHapticSession;
class vtkPolyData;
class vtkRegimeMap;
class vtkRenderWindow;
class vtkRenderer;
class vtkResponseChart;

class PALPATECOMPARISON_EXPORT vtkBodyComparison : public vtkObject
{
public:
  static vtkBodyComparison* New();
  vtkTypeMacro(vtkBodyComparison, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Which of the two bodies.
  enum BodySide
  {
    Left = 0,
    Right = 1
  };
  /// What the bodies are coloured by.
  enum BodyColor
  {
    Displacement = 0,
    RegimeIndex = 1,
    ToolSensitivity = 2,
    RegimeVerdict = 3
  };

  /** The window; the renderers are added. Call once. Laid out for 1280 x 960. */
  void SetRenderWindow(vtkRenderWindow* window);

  /** A body with the responses of all tools, and its name in the picture. */
  void SetBody(int side, vtkPolyData* body, const std::string& title);
  vtkPolyData* GetBody(int side);

  ///@{
  /** A tool, and the prefix of its responses on both bodies. */
  void AddTool(vtkContactTool* tool, const std::string& responseName);
  void RemoveAllTools();
  int GetNumberOfTools();
  ///@}

  ///@{
  /** Which of the tools touches, from 0. Default 0. */
  void SetShownTool(int tool);
  vtkGetMacro(ShownTool, int);
  ///@}

  ///@{
  /** Of both bodies; MPa. Defaults 0.1 and 0.45. */
  void SetYoungsModulus(double modulus);
  vtkGetMacro(YoungsModulus, double);
  void SetPoissonRatio(double ratio);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** Depth of the verdict and end of the colours of the displacement, mm, > 0. Default 1. */
  void SetDeflection(double deflection);
  vtkGetMacro(Deflection, double);
  ///@}

  ///@{
  /** What the bodies are coloured by. Default Displacement. */
  bool SetColor(int color);
  vtkGetMacro(Color, int);
  ///@}

  ///@{
  /** Shows a contact on both bodies: tip `index` of two outputs of vtkToolContactProbe or
   * recordings; or the newest tick of two sessions. */
  bool ShowTips(vtkPolyData* left, vtkPolyData* right, vtkIdType index);
  bool ShowSessions(vtkHapticSession* left, vtkHapticSession* right);
  ///@}

  /** Curves and verdicts at the points of the bodies next to a place, mm. */
  bool ShowPlace(double x, double y, double z);

  /** Sets the camera to show both bodies whole from `direction`; `up` points up. */
  void LookAtBodies(const double direction[3], const double up[3]);

  ///@{
  /**
   * The results at the last contact or place shown. Of one tool: force (N), λ, sensitivity; NaN
   * before the first. Of all: the verdict (0 shape matters, 1 mixed, 2 a point force suffices; -1
   * before the first), (largest - smallest force)/mean, the depths (mm) from and to which the
   * verdict is the same, the depth to which the responses are valid, and all this in words.
   */
  double GetForce(int side, int tool);
  double GetRegimeIndex(int side, int tool);
  double GetToolSensitivity(int side, int tool);
  int GetVerdict(int side);
  double GetForceSpread(int side);
  void GetVerdictRange(int side, double range[2]);
  double GetValidity(int side);
  std::string GetStatement(int side);
  ///@}

  ///@{
  /** The parts, to add to them or restyle them. */
  vtkContactScene* GetScene(int side);
  vtkRenderer* GetRenderer(int side);
  vtkResponseChart* GetChart(int side);
  vtkRegimeMap* GetMap(int side);
  ///@}

protected:
  vtkBodyComparison();
  ~vtkBodyComparison() override;

private:
  vtkBodyComparison(const vtkBodyComparison&) = delete;
  void operator=(const vtkBodyComparison&) = delete;

  struct Columns;
  void ShareMaterial();
  bool Report(const std::string& error);

  std::unique_ptr<Columns> Parts;
  int ShownTool = 0;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double Deflection = 1.0;
  int Color = Displacement;
};

#endif
