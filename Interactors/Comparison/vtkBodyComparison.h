// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkBodyComparison
 * @brief two bodies side by side under the same tools and motion, to show whether the shape of the
 * tool has an effect
 *
 * The class illustrates section 2 of Mahvash and Hayward (2002): on a body that deforms globally
 * the forces of all tools are equal, on a body that deforms locally they differ.
 *
 * The inputs are a window, two bodies with responses of the same tools under the same names, and
 * the tools. Each half of the window shows three parts, from top to bottom. The first part is the
 * body under the shown tool (vtkContactScene). The second part is a chart of force over deflection
 * for all tools at the point of contact (vtkResponseChart, dotted beyond validity), with a marker
 * for the present contact of the shown tool. The third part is the verdict in words: λ and tool
 * sensitivity (vtkContactRegime) at Deflection, the spread of the forces, the depths at which the
 * verdict is the same, and the depth to which the responses are valid. The verdict is the most
 * cautious one of all tools. Both bodies share one camera. Axes and force arrows have separate
 * scales, because the forces may differ by a factor of a hundred.
 *
 * Both bodies have the same material (YoungsModulus, PoissonRatio). The point arrays
 * `GlobalCompliance` (mm/N) and `LayerThickness` (mm), if present, describe their support and
 * layers. Material and responses must agree; if they do not agree, the map reports an error that
 * names a point.
 *
 * ShowTips shows one tip of vtkToolContactProbe or of a recording on each body. ShowSessions shows
 * the newest ticks of two sessions. Curves and verdict are updated when the contact moves to
 * another vertex; one update takes a few milliseconds. Color selects the colours of the bodies: the
 * displacement, or one of the maps of vtkRegimeMap. The first display of a map takes a few seconds
 * per million points.
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

  /// The sides of the window on which the two bodies are shown.
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

  /** The window, to which the renderers are added. Call once. The layout is designed for 1280 x 960
   * pixels. */
  void SetRenderWindow(vtkRenderWindow* window);

  /** Sets the body of a side and its title in the picture. The body must have the responses of all
   * tools. */
  void SetBody(int side, vtkPolyData* body, const std::string& title);
  vtkPolyData* GetBody(int side);

  ///@{
  /** Adds a tool. `responseName` is the prefix of its response arrays on both bodies. */
  void AddTool(vtkContactTool* tool, const std::string& responseName);
  void RemoveAllTools();
  int GetNumberOfTools();
  ///@}

  ///@{
  /** Index of the tool that touches the bodies, from 0. Default 0. */
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
  /** Depth for which the verdict is given, and upper end of the colours of the displacement, mm, >
   * 0. Default 1. */
  void SetDeflection(double deflection);
  vtkGetMacro(Deflection, double);
  ///@}

  ///@{
  /** The quantity that the colours of the bodies show. Default Displacement. */
  bool SetColor(int color);
  vtkGetMacro(Color, int);
  ///@}

  ///@{
  /** Shows a contact on both bodies. ShowTips shows the tip with index `index` of two outputs of
   * vtkToolContactProbe or of two recordings. ShowSessions shows the newest ticks of two
   * sessions. */
  bool ShowTips(vtkPolyData* left, vtkPolyData* right, vtkIdType index);
  bool ShowSessions(vtkHapticSession* left, vtkHapticSession* right);
  ///@}

  /** Shows curves and verdicts at the vertex of each body that is nearest to (x, y, z), mm. */
  bool ShowPlace(double x, double y, double z);

  /** Sets the camera so that it shows both bodies completely from `direction`. `up` is the upward
   * direction in the picture. */
  void LookAtBodies(const double direction[3], const double up[3]);

  ///@{
  /**
   * The results at the last contact or point that was shown. The results for one tool are force
   * (N), λ and sensitivity; they are NaN before the first contact or point. The results for all
   * tools are the verdict, the spread (largest force - smallest force)/mean, the depths (mm) from
   * and to which the verdict is the same, and the depth to which the responses are valid. The
   * verdict is 0 if shape matters, 1 if mixed, 2 if a point force suffices, and -1 before the first
   * contact or point. The last function returns all results in words.
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
  /** The parts of the picture. Use them for additions and changes of style. */
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
