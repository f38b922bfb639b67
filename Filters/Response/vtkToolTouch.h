// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkToolTouch
 * @brief one touch of a body, ready to be shown: dent, tool, force arrow and numbers
 *
 * Input: a body with response arrays (vtkToolContactResponse), mm. The tool is the one that the
 * response names. The place of the touch:
 * - Snap on (default): the point of the surface nearest to TipPosition, pressed Indentation deep
 *   along the contact normal. It touches for any TipPosition.
 * - Snap off: the tip is at TipPosition, moved inward by Indentation along the normal at its
 *   nearest surface point. Outside the body there is no contact.
 *
 * Output:
 * - 0 the dented body: the input with its points moved by `ContactDisplacement`
 *   (vtkContactDeflection within Reach contact radii), and the point array `Dent (mm)`, the inward
 *   displacement along the contact normal, as active scalars. All arrays of the body pass through;
 *   those of the response remain those of the undeformed body. Active point normals follow the
 *   dent.
 * - 1 the tool, triangles with normals, tip in place, axis along the contact normal.
 * - 2 the force as an arrow from the tip, ForceScale mm long per N; empty without contact.
 * - 3 the numbers as text with units: a vtkTable with one string, column `Text`.
 *
 * The arrow has `Force` (N, 3) at its points. Its field arrays, one tuple each, are all arrays of
 * vtkToolContactProbe - `Force`, `NormalForce`, `FrictionForce`, `Deflection`, `Normal`,
 * `ContactPoint`, `ContactCell`, `ContactState` - and `TipPosition` (3, mm, after snap and
 * indentation), `Stiffness` (N/mm: dF/dδ of the blended curves), `Validity` (mm: the depth at which
 * the law's first assumption fails, the smallest of the triangle's corners; infinite if none fails
 * or the response has no validity) and `ForceScale` (mm/N).
 *
 * With SecondTip another tool of the same kind presses at SecondTipPosition and is placed in the
 * same way. The outputs then have both dents, tools and arrows, and the numbers of both. If the
 * response has its coupling (vtkToolContactResponse::CouplingOn), the tools interact, and
 * Deflection is that of each tool's own dent, as in vtkToolContactProbe with Coupled. Otherwise
 * each has the force it has alone, and the text says so. The arrow's field arrays then have a tuple
 * for each tool.
 *
 * Friction does not act: one touch has no history. For the same reason a body that relaxes has its
 * slow response, as after a long touch. A body without the response is an error that names the
 * missing array; an empty body gives empty output. With several processes (the global
 * controller's), one process must have the whole body; otherwise it is an error. All processes must
 * update the filter.
 *
 * Cost: once per state of the body, the kernel's copy (vtkToolContactProbe) and the neighbours of
 * its mesh, O(n log n). Then per move a copy of the points and a few microseconds per point of the
 * dent.
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
   * Position of the tip in the body's frame, mm. Until it is set, Get returns 0, 0, 0, and the tip
   * is at the place that FindStart finds from +z with y up, on each body.
   */
  virtual void SetTipPosition(double x, double y, double z);
  virtual void SetTipPosition(const double position[3])
  {
    this->SetTipPosition(position[0], position[1], position[2]);
  }
  vtkGetVector3Macro(TipPosition, double);
  ///@}

  /**
   * Finds a good place to begin a touch, for a viewer in the direction `towards` (from the body to
   * the viewer, not zero) with `up` upward in the picture. Writes a point of the surface, mm, to
   * `start`. The place is visible and near the middle. It is flat over the contact at half of Range
   * and its surroundings. It faces the viewer, and its normal leans upward, so that tool and force
   * are seen from the side. If possible it is within the response's validity. If no point on that
   * side has a response, the next of +z, +x, +y, -z, -x, -y is tried. The result depends on shape,
   * response and direction only. Returns false, and leaves `start` unchanged, for a body without a
   * valid response. Takes about 0.2 s.
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
   * Distance by which the tip is moved inward, mm, finite and not negative. Default 0: with Snap,
   * half of the response's Range there; without Snap, no movement.
   */
  vtkSetMacro(Indentation, double);
  vtkGetMacro(Indentation, double);
  ///@}

  ///@{
  /**
   * The settings of the contact. Other objects may share them. Friction does not act, since a
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
   * begins at 3/4 of it. Default 20, where the dent is a thirtieth of the deflection.
   */
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * Length of the arrow per force, mm/N, finite and not negative. Default 0: automatic. The force
   * at half of Range, averaged over the body, is then about a fifth of the body's diagonal long;
   * the scale is rounded to 1, 2 or 5. So on one body a longer arrow means a larger force at any
   * place.
   */
  vtkSetMacro(ForceScale, double);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /**
   * Height of the drawn tool, mm, finite and not negative. Default 0: a quarter of the body's
   * diagonal.
   */
  vtkSetMacro(ToolLength, double);
  vtkGetMacro(ToolLength, double);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  /** Includes the modification time of the settings. */
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
  /// Computes the touch at a position, without the other tool.
  palpate::Touch PressAlone(const double position[3]);
  /// Moves the tips to their places and probes the body there.
  std::vector<palpate::Touch> Probe();
  bool MakeDent(const std::vector<palpate::Touch>& touches, vtkPolyData* output);
  bool MakeTools(const std::vector<palpate::Touch>& touches, vtkPolyData* output);
  void MakeArrows(const std::vector<palpate::Touch>& touches, vtkPolyData* output);
  /// Reports the fault as an error, unless it is "".
  bool Fail(const std::string& fault);

  vtkSmartPointer<vtkContactSettings> Settings; ///< never null
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
  double Start[3] = { 0.0, 0.0, 0.0 }; ///< used if TipPosition was not set
  bool StartIsFound = false;
  vtkPolyData* Source = nullptr;
  vtkMTimeType SourceTime = 0;
  std::string SourceResponse;
};

#endif
