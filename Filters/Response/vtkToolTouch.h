// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToolTouch
 * @brief computes one touch of a body for display: dent, tool, force arrow and numbers
 *
 * Input: a body with response arrays (vtkToolContactResponse), mm. The tool is the tool that the
 * response names. The property Snap determines the place of the touch:
 * - Snap on (default): the point of the surface nearest to TipPosition is pressed by Indentation
 *   along the contact normal. The tool touches for any TipPosition.
 * - Snap off: the tip is moved from TipPosition inward by Indentation along the normal at the
 *   nearest surface point. If it is then outside the body, there is no contact.
 *
 * Output:
 * - 0 the dented body: the input with its points moved by `ContactDisplacement`
 *   (vtkContactDeflection within Reach contact radii), and the point array `Dent (mm)`, the inward
 *   displacement along the contact normal, as active scalars. All arrays of the body pass through.
 *   The arrays of the response still describe the undeformed body. Active point normals follow the
 *   dent.
 * - 1 the tool as triangles with normals. Its tip is at the contact, and its axis is along the
 *   contact normal.
 * - 2 the force as an arrow from the tip, with a length of ForceScale mm per N. It is empty without
 *   contact.
 * - 3 the numbers as text with units, in a vtkTable with one string in the column `Text`.
 *
 * The arrow has the point array `Force` (N, 3 components). Its field arrays have one tuple each.
 * They are the arrays of vtkToolContactProbe - `Force`, `NormalForce`, `FrictionForce`,
 * `Deflection`, `Normal`, `ContactPoint`, `ContactCell`, `ContactState` - and also `TipPosition` (3
 * components, mm, after snap and indentation), `Stiffness` (N/mm: dF/dδ of the blended curves),
 * `Validity` (mm: the depth at which the first assumption of the law fails, the smallest value of
 * the triangle's corners; infinite if no assumption fails or the response has no validity) and
 * `ForceScale` (mm/N).
 *
 * With SecondTip another tool of the same kind presses at SecondTipPosition and is placed in the
 * same way. The outputs then have the dents, tools, arrows and numbers of both tools. If the
 * response has a coupling (vtkToolContactResponse::CouplingOn), the tools interact, and Deflection
 * is that of each tool's own dent, as in vtkToolContactProbe with Coupled. Otherwise each tool has
 * the force of a single tool, and the text states this. The field arrays of the arrow then have a
 * tuple for each tool.
 *
 * Friction has no effect, because one touch has no history. For the same reason, a body that
 * relaxes responds with its slow force, as after a long touch. If the body lacks the response, an
 * error names the missing array. An empty body gives empty output. With several processes (the
 * global controller), one process must have the whole body; otherwise this is an error. All
 * processes must update the filter.
 *
 * Cost: for each state of the body, the filter creates the kernel's copy (vtkToolContactProbe) and
 * the neighbours of its mesh, in O(n log n). Each move then takes a copy of the points and a few
 * microseconds per point of the dent.
 *
 * @code{.py}
 * touch = palpate.vtkToolTouch()
 * touch.SetInputData(body)                             # with a response
 * touch.SetTipPosition(0, 0, 60)                       # mm; moved to the nearest point of the body
 * touch.SetIndentation(1.0)                            # mm
 * touch.Update()
 * print(touch.GetOutputDataObject(3).GetValue(0, 0).ToString())
 * @endcode
 */
#ifndef vtkToolTouch_h
#define vtkToolTouch_h

#include "palpateResponseModule.h" // For export macro
#include "vtkNew.h"                // For vtkNew
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkContactSettings;
class vtkContactTool;
class vtkPolyData;

namespace palpate
{
class BodyField;
class TouchedBody;
struct ContactBody;
struct Touch;
} // namespace palpate

class PALPATERESPONSE_EXPORT vtkToolTouch : public vtkPolyDataAlgorithm
{
public:
  static vtkToolTouch* New();
  vtkTypeMacro(vtkToolTouch, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Indices of the output ports.
  enum OutputPort
  {
    BodyPort = 0,
    ToolPort = 1,
    ArrowPort = 2,
    TextPort = 3
  };

  ///@{
  /**
   * Position of the tip in the body's frame, mm. Until it is set, GetTipPosition returns 0, 0, 0,
   * and on each body the tip is at the place that FindStart returns for a viewer along +z with y
   * up.
   */
  virtual void SetTipPosition(double x, double y, double z);
  virtual void SetTipPosition(const double position[3])
  {
    this->SetTipPosition(position[0], position[1], position[2]);
  }
  vtkGetVector3Macro(TipPosition, double);
  ///@}

  /**
   * Finds a good place to begin a touch. `towards` is the direction from the body to the viewer and
   * must not be zero. `up` is the upward direction in the picture. `start` receives a point of the
   * surface, mm. The place is visible and near the middle. The surface is nearly flat within and
   * around the contact at half of Range. The place faces the viewer, and its normal is tilted
   * upward, so that tool and force are seen from the side. If possible, the depth is within the
   * response's validity. If no visible point has a response, the directions +z, +x, +y, -z, -x, -y
   * are tried in this order. The result depends only on shape, response and direction. Returns
   * false, and leaves `start` unchanged, for a body without a valid response. Takes about 0.2 s.
   */
  static bool FindStart(vtkPolyData* body, const std::string& responseName, const double towards[3],
    const double up[3], double start[3]);

  ///@{
  /** Whether the tip is first moved to the nearest point of the surface. Default on. */
  vtkSetMacro(Snap, bool);
  vtkGetMacro(Snap, bool);
  vtkBooleanMacro(Snap, bool);
  ///@}

  ///@{
  /** Whether a second tool presses at the same time. Default off. */
  vtkSetMacro(SecondTip, bool);
  vtkGetMacro(SecondTip, bool);
  vtkBooleanMacro(SecondTip, bool);
  ///@}
  ///@{
  /** Position of the second tip in the body's frame, mm. Default 0, 0, 0. */
  vtkSetVector3Macro(SecondTipPosition, double);
  vtkGetVector3Macro(SecondTipPosition, double);
  ///@}

  ///@{
  /**
   * Distance by which the tip is moved inward, mm, finite and not negative. The default 0 means
   * half of the response's Range at the nearest point with Snap, and no movement without Snap.
   */
  vtkSetMacro(Indentation, double);
  vtkGetMacro(Indentation, double);
  ///@}

  ///@{
  /**
   * The settings of the contact. Other objects may share them. Friction has no effect, because a
   * single tip has no history. Null sets a separate object, which is also the default.
   */
  virtual void SetSettings(vtkContactSettings* settings);
  vtkContactSettings* GetSettings();
  ///@}

  ///@{
  /** Poisson's ratio of the body, 0 to 0.5. Default 0.45. Used only for the shape of the dent. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /**
   * Distance from the contact, in contact radii, at which the dent has faded out, positive. Fading
   * begins at 3/4 of this distance. Default 20. At 20 contact radii the dent is a thirtieth of the
   * deflection.
   */
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * Length of the arrow per force, mm/N, finite and not negative. With the default 0, the scale is
   * chosen such that the arrow for the force at half of Range, averaged over the body, has a length
   * of about a fifth of the body's diagonal. The chosen scale is rounded to 1, 2 or 5 times a power
   * of ten. It is the same at all places of one body, so that a longer arrow means a larger force.
   */
  vtkSetMacro(ForceScale, double);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /**
   * Height of the drawn tool, mm, finite and not negative. The default 0 selects a quarter of the
   * body's diagonal.
   */
  vtkSetMacro(ToolLength, double);
  vtkGetMacro(ToolLength, double);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  /** Returns the modification time of the filter, including that of the settings. */
  vtkMTimeType GetMTime() override;

protected:
  vtkToolTouch();
  ~vtkToolTouch() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkToolTouch(const vtkToolTouch&) = delete;
  void operator=(const vtkToolTouch&) = delete;

  bool CheckSettings();
  /// Updates body, tool and force scale if they have changed.
  bool PrepareBody(vtkPolyData* body);
  /// Computes the touch at a position without the effect of the other tool.
  palpate::Touch PressAlone(const double position[3]);
  /// Moves the tips to their final positions and probes the body at these positions.
  std::vector<palpate::Touch> Probe();
  bool MakeDent(const std::vector<palpate::Touch>& touches, vtkPolyData* output);
  bool MakeTools(const std::vector<palpate::Touch>& touches, vtkPolyData* output);
  void MakeArrows(const std::vector<palpate::Touch>& touches, vtkPolyData* output);
  /// Reports the fault as an error, unless it is "".
  bool Fail(const std::string& fault);

  vtkSmartPointer<vtkContactSettings> Settings; ///< settings of the contact; never null
  double TipPosition[3] = { 0.0, 0.0, 0.0 };
  bool TipIsSet = false;
  bool SecondTip = false;
  double SecondTipPosition[3] = { 0.0, 0.0, 0.0 };
  bool Snap = true;
  double Indentation = 0.0;
  double PoissonRatio = 0.45;
  double Reach = 20.0;
  double ForceScale = 0.0;
  double ToolLength = 0.0;
  std::string ResponseName = "Response";

  vtkNew<vtkPolyData> Probed; ///< the tips, with the arrays of vtkToolContactProbe
  // The last body, and the objects made from it.
  std::unique_ptr<palpate::TouchedBody> Touched;
  std::unique_ptr<palpate::BodyField> Field;
  std::unique_ptr<palpate::BodyField> SecondField;
  std::shared_ptr<const palpate::ContactBody> Contact;
  vtkSmartPointer<vtkPolyData> Body;
  vtkSmartPointer<vtkContactTool> Tool;
  double AutomaticScale = 0.0;
  double Start[3] = { 0.0, 0.0, 0.0 }; ///< start of the touch, used if TipPosition was not set
  bool StartIsFound = false;
  vtkPolyData* Source = nullptr;
  vtkMTimeType SourceTime = 0;
  std::string SourceResponse;
};

#endif
