// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkBodyComparison
 * @brief two bodies side by side under the same tools and motion, to show whether the shape of the
 * tool has an effect
 *
 * The class illustrates Mahvash and Hayward (2002), section 2: on a body that deforms globally all
 * tools have the same force, on a body that deforms locally they do not.
 *
 * The inputs are a window, two bodies with responses of the same tools under the same names, and
 * the tools. Each half of the window shows three parts, from top to bottom. First, the body under
 * the shown tool (vtkContactScene). Second, force over deflection of all tools at the point of
 * contact (vtkResponseChart, dotted beyond validity), with the present point of the shown tool.
 * Third, the verdict in words: λ and tool sensitivity (vtkContactRegime) at Deflection, the spread
 * of the forces, the depths at which the verdict is the same, and the depth to which the responses
 * are valid. The verdict is the most cautious one of all tools. Both bodies share one camera. Axes
 * and force arrows have separate scales, because the forces may differ by a factor of a hundred.
 *
 * Both bodies have the same material (YoungsModulus, PoissonRatio). The point arrays
 * `GlobalCompliance` (mm/N) and `LayerThickness` (mm), if present, describe their support and
 * layers. Material and responses must agree; if they do not, a map reports an error that names a
 * point.
 *
 * ShowTips shows one tip in each of both scenes, from vtkToolContactProbe or a recording;
 * ShowSessions shows the newest tick of two sessions. Curves and verdict are updated when the
 * contact moves to another vertex; one update takes a few milliseconds. Color selects the colours
 * of the bodies: the displacement, or one of the maps of vtkRegimeMap. A map takes a few seconds
 * per million points when it is first shown.
 *
 * Errors are reported by vtkErrorMacro; the function then returns false.
 *
 * @code{.py}
 * comparison = palpate.vtkBodyComparison()
 * comparison.SetRenderWindow(window)
 * comparison.SetBody(0, strip, "a strip that bends")
 * comparison.SetBody(1, block, "a block that dents")
 * comparison.AddTool(tool, "Response")                 # responses of both bodies
 * comparison.SetYoungsModulus(0.05)                    # MPa
 * comparison.ShowPlace(0, 0, 50)                       # mm
 * @endcode
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

  /// The two bodies.
  enum BodySide
  {
    Left = 0,
    Right = 1
  };
  /// Quantities that the colours of the bodies can show.
  enum BodyColor
  {
    Displacement = 0,
    RegimeIndex = 1,
    ToolSensitivity = 2,
    RegimeVerdict = 3
  };

  /** The window; the renderers are added. Call once. Laid out for 1280 x 960. */
  void SetRenderWindow(vtkRenderWindow* window);

  /** Sets a body with the responses of all tools, and its name in the picture. */
  void SetBody(int side, vtkPolyData* body, const std::string& title);
  vtkPolyData* GetBody(int side);

  ///@{
  /** Adds a tool; `responseName` is the prefix of its responses on both bodies. */
  void AddTool(vtkContactTool* tool, const std::string& responseName);
  void RemoveAllTools();
  int GetNumberOfTools();
  ///@}

  ///@{
  /** Number of the tool that touches the bodies, from 0. Default 0. */
  void SetShownTool(int tool);
  vtkGetMacro(ShownTool, int);
  ///@}

  ///@{
  /** Young's modulus (MPa) and Poisson's ratio of both bodies. Defaults 0.1 and 0.45. */
  void SetYoungsModulus(double modulus);
  vtkGetMacro(YoungsModulus, double);
  void SetPoissonRatio(double ratio);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** Depth of the verdict and upper end of the colours of the displacement, mm, > 0. Default 1. */
  void SetDeflection(double deflection);
  vtkGetMacro(Deflection, double);
  ///@}

  ///@{
  /** The quantity that the colours of the bodies show. Default Displacement. */
  bool SetColor(int color);
  vtkGetMacro(Color, int);
  ///@}

  ///@{
  /** Shows a contact on both bodies: tip `index` of two outputs of vtkToolContactProbe or
   * recordings; or the newest tick of two sessions. */
  bool ShowTips(vtkPolyData* left, vtkPolyData* right, vtkIdType index);
  bool ShowSessions(vtkHapticSession* left, vtkHapticSession* right);
  ///@}

  /** Shows curves and verdicts at the points of the bodies nearest to (x, y, z), mm. */
  bool ShowPlace(double x, double y, double z);

  /** Sets the camera so that it shows both bodies completely from `direction`; `up` points up. */
  void LookAtBodies(const double direction[3], const double up[3]);

  ///@{
  /**
   * The results at the last contact or point shown. For one tool: force (N), λ, sensitivity; NaN if
   * nothing was shown yet. For all tools: the verdict (0 shape matters, 1 mixed, 2 a point force
   * suffices; -1 if nothing was shown yet), (largest - smallest force)/mean, the depths (mm) from
   * and to which the verdict is the same, the depth to which the responses are valid, and all of
   * these in words.
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
  /** The parts of the picture, for additions and changes of style. */
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
