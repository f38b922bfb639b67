// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactSetup
 * @brief body, tools, material and model of a contact, and the responses for them
 *
 * Set tools, a body without responses, and the material of the body. Update makes the responses of
 * all tools. The array names of each response have their own prefix: `Response` for the first tool,
 * then `Response2`, `Response3`... GetOutput is the body with the responses. GetTool and
 * GetResponseName return the tools and the prefixes. ApplyTo passes the responses to a session,
 * which may be running; ShowIn passes them to a scene.
 *
 * Making responses takes about a second for a few hundred thousand points. A live session must not
 * wait so long. Therefore Request makes the responses, and the kernels for the session, on another
 * thread. Of several requests only the newest is processed. Collect, called once per frame, takes
 * over the finished responses. Until then, and after an error, output, session and scene do not
 * change.
 *
 * A change of Young's modulus scales the responses within 50 ms, unless other moduli of the body
 * stay the same. A change of Poisson's ratio of a HalfSpace scales the forces equally fast. Errors
 * and validities are then computed in the background; meanwhile IsBusy returns true, and a second
 * Collect takes them over.
 *
 * Lengths in mm, moduli in MPa. The body is not modified. Do not change its points and cells in
 * place after SetBody; call SetBody again after a change. Only one thread, the graphics thread, may
 * use this object. Only Update blocks that thread.
 *
 * @code{.py}
 * setup = palpate.vtkContactSetup()
 * setup.SetBody(triangles)                             # mm, without responses
 * setup.AddTool(tool)
 * setup.SetYoungsModulus(0.05)                         # MPa
 * setup.Update()                                       # or Request, and Collect once a frame
 * setup.ApplyTo(session)
 * setup.ShowIn(scene)
 * @endcode
 */
#ifndef vtkContactSetup_h
#define vtkContactSetup_h

#include "Response/Curves/RelaxationList.h" // For palpate::RelaxationList
#include "palpateInteractionModule.h"       // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkContactScene;
class vtkContactSettings;
class vtkContactTool;
class vtkHapticSession;
class vtkPolyData;

namespace palpate
{
struct MadeResponses;
struct ResponseRequest;
} // namespace palpate

class PALPATEINTERACTION_EXPORT vtkContactSetup : public vtkObject
{
public:
  static vtkContactSetup* New();
  vtkTypeMacro(vtkContactSetup, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModelType
  {
    HalfSpace = 0,
    /// One or more layers. The thickness of the first layer (mm) is the property LayerThickness or
    /// the array of that name. Further layers are those of AddLayer. Their base is LayerBase.
    Layer = 1,
    Series = 2, ///< local deflection in series with the array GlobalCompliance (mm/N)
    Stored = 3  ///< the responses that the body already has, used unchanged
  };

  ///@{
  /**
   * The body: triangles, with outward normals if it has any, and the arrays that the models need.
   */
  void SetBody(vtkPolyData* body);
  vtkPolyData* GetBody();
  ///@}

  ///@{
  /** The tools. A change of a tool counts as a change of the setup. With the model Stored, the
   * tools are only drawn, because the responses are given. */
  void AddTool(vtkContactTool* tool);
  void RemoveAllTools();
  int GetNumberOfTools();
  /** Returns the tool with this index, or null if there is none. */
  vtkContactTool* GetTool(int tool);
  /** Prefix of the names of the response arrays of a tool. */
  std::string GetResponseName(int tool);
  ///@}

  ///@{
  /** Index of the chosen tool, from 0. Choosing another tool needs no new responses. Default 0. */
  void SetChosenTool(int tool);
  vtkGetMacro(ChosenTool, int);
  vtkContactTool* GetToolInHand() { return this->GetTool(this->ChosenTool); }
  ///@}

  ///@{
  /** Young's modulus, MPa, > 0. Default 0.1. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  ///@}
  ///@{
  /**
   * Poisson's ratio, 0 to 0.5. Default 0.45. The compliance of the model Series does not change
   * with Poisson's ratio.
   */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}
  ///@{
  /** Deflection of the last sample, mm, > 0. Default 2. */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  ///@}

  ///@{
  /** The model of the body below the surface (ModelType). Default HalfSpace. */
  vtkSetMacro(Model, int);
  vtkGetMacro(Model, int);
  ///@}
  /** Whether the body and the properties have the data that `model` needs. If Model is Stored, the
   * result is false for all other models. */
  bool HasModel(int model);
  ///@{
  /**
   * Thickness of the layer, mm, equal at all points. With 0, the default, the array LayerThickness
   * gives the thickness.
   */
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  ///@}
  ///@{
  /** Layers below the first layer, for the model Layer, as in vtkToolContactResponse. Only the
   * first of these layers may have the thickness 0; its thickness is then given by the point array
   * LayerThickness1. If there are added layers and LayerThickness is 0, the array LayerThickness0
   * gives the thickness of the first layer. Default none. */
  void AddLayer(double thickness, double youngsModulus, double poissonRatio, bool slips = false);
  void ClearLayers();
  int GetNumberOfAddedLayers();
  ///@}
  ///@{
  /** The base of the layers, as LayerBase of vtkToolContactResponse. With 0, the default, the
   * layers are bonded to a rigid base; with 1 they slip on a rigid base. With 2 the base is an
   * elastic half-space with BaseYoungsModulus (MPa, default 1) and BasePoissonRatio (default 0.45);
   * BaseSlips is whether the layers slip on it. */
  vtkSetClampMacro(LayerBase, int, 0, 2);
  vtkGetMacro(LayerBase, int);
  vtkSetMacro(BaseYoungsModulus, double);
  vtkGetMacro(BaseYoungsModulus, double);
  vtkSetMacro(BasePoissonRatio, double);
  vtkGetMacro(BasePoissonRatio, double);
  vtkSetMacro(BaseSlips, bool);
  vtkGetMacro(BaseSlips, bool);
  vtkBooleanMacro(BaseSlips, bool);
  ///@}
  ///@{
  /** Young's modulus (MPa) for which GlobalCompliance and the global modes of the body were
   * computed. They are scaled to the present modulus. With 0, the default, they are not scaled. */
  vtkSetMacro(ComplianceModulus, double);
  vtkGetMacro(ComplianceModulus, double);
  ///@}

  ///@{
  /** Whether the curvature of the body is included; see vtkToolContactResponse. Default on. */
  vtkSetMacro(CurvatureCorrection, bool);
  vtkGetMacro(CurvatureCorrection, bool);
  vtkBooleanMacro(CurvatureCorrection, bool);
  ///@}
  ///@{
  /** Whether the effect of sharp edges is included; see vtkToolContactResponse. Default off. */
  vtkSetMacro(EdgeCorrection, bool);
  vtkGetMacro(EdgeCorrection, bool);
  vtkBooleanMacro(EdgeCorrection, bool);
  ///@}
  ///@{
  /** Largest tilt of the tools, degrees; see vtkToolContactResponse. With 0, the default, tools are
   * upright. */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}
  ///@{
  /** Whether tools that press at the same time affect one another through the deflection of the
   * surface; see vtkToolContactResponse. Default off. */
  vtkSetMacro(Coupling, bool);
  vtkGetMacro(Coupling, bool);
  vtkBooleanMacro(Coupling, bool);
  ///@}
  ///@{
  /** Relaxation of the body by up to four branches, each with a strength and a time (s); see
   * vtkToolContactResponse. A branch of strength 0 has no effect. Default: no branches.
   * ComplianceRelaxes is whether the global compliance of the model Series also relaxes; default
   * on. */
  void AddRelaxation(double strength, double seconds)
  {
    this->Relaxations.add(strength, seconds);
    this->Modified();
  }
  /** Sets strength and time of the branch with index `relaxation`, from 0. An index equal to the
   * number of branches adds a branch. */
  void SetRelaxation(int relaxation, double strength, double seconds)
  {
    if (this->Relaxations.set(relaxation, strength, seconds))
    {
      this->Modified();
    }
  }
  void ClearRelaxations()
  {
    if (this->Relaxations.clear())
    {
      this->Modified();
    }
  }
  int GetNumberOfRelaxations() { return this->Relaxations.count(); }
  double GetRelaxationStrength(int relaxation) { return this->Relaxations.strength(relaxation); }
  double GetRelaxationTime(int relaxation) { return this->Relaxations.seconds(relaxation); }
  vtkSetMacro(ComplianceRelaxes, bool);
  vtkGetMacro(ComplianceRelaxes, bool);
  vtkBooleanMacro(ComplianceRelaxes, bool);
  ///@}
  ///@{
  /** Law of the body at large strain, a value of vtkToolContactResponse::StrainModelType. Default
   * SmallStrain. */
  vtkSetClampMacro(StrainModel, int, 0, 3);
  vtkGetMacro(StrainModel, int);
  ///@}
  ///@{
  /** The exponent of Ogden's or Demiray's law. Default 2. */
  vtkSetMacro(StrainExponent, double);
  vtkGetMacro(StrainExponent, double);
  ///@}
  ///@{
  /** The estimated relative error of the force up to which the responses are valid. With 0 the
   * error is not estimated, and the responses are valid until the first assumption fails. Default
   * 0.05. */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  ///@}
  ///@{
  /** Whether the law includes only those terms that change the forces by more than Tolerance, or by
   * more than 1 % if Tolerance is 0; see vtkToolContactResponse. Default off. */
  vtkSetMacro(AutomaticTerms, bool);
  vtkGetMacro(AutomaticTerms, bool);
  vtkBooleanMacro(AutomaticTerms, bool);
  ///@}

  ///@{
  /** Largest relative error of the force of a simpler form of the response. A session uses the
   * simplest form within this error instead of a curve per point (vtkResponseChoice). With 0, the
   * default, sessions use the responses unchanged. The output always has the full responses. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}
  ///@{
  /** Deflection for which the form is chosen, mm. Used if Tolerance is not 0. With 0, the default,
   * half of MaximumDeflection is used. */
  vtkSetMacro(ChoiceDeflection, double);
  vtkGetMacro(ChoiceDeflection, double);
  ///@}

  /**
   * Makes the responses on the calling thread and with the priority of this thread. ProgressEvent
   * reports the completed fraction (double). Returns false after an error; the output is then
   * unchanged.
   */
  bool Update();
  /** Makes the responses in the background, with a lower priority. Does nothing if responses for
   * the present settings exist or are being made. */
  void Request();
  /** Whether requested responses are still being made. */
  bool IsBusy();
  /** Completed fraction of the requested work, 0 to 1. It is 1 if no request is pending. */
  double GetProgress();
  /** Returns a sentence about the forces that are still shown while the requested responses are not
   * ready: "Computing: still the force of E = 35 kPa". Returns "" if no request is pending. */
  std::string GetPendingText();
  /** Withdraws the request. Young's modulus, Poisson's ratio, model, relaxations and the sizes of
   * the tools return to the values for which the output was made. No effect if no request is
   * pending. */
  void Cancel();
  /** Takes over the requested responses if they are ready. Never waits. Returns true if responses
   * were taken over. This happens once per request, but twice after a change of Poisson's ratio of
   * a HalfSpace. Returns false, after an error, if the responses could not be made. */
  bool Collect();
  /** The error of the newest request; "" if the request succeeded. */
  vtkGetMacro(Error, std::string);

  /**
   * The body with the responses. It is null before the first Update or Collect. Each Update or
   * Collect makes a new object.
   */
  vtkPolyData* GetOutput();
  /** The tool for which the response with this index was made. It is null before the first Update
   * or Collect. */
  vtkContactTool* GetOutputTool(int tool);

  /** Returns a sentence about the form of a tool's response that sessions use, with the reason.
   * Returns "" if Tolerance is 0, and before the first Update or Collect. */
  std::string GetChoice(int tool);

  /** Largest force, N, over all tools of the output and all points, at MaximumDeflection. It is 0
   * before the first Update or Collect. */
  double GetLargestForce();

  ///@{
  /** Contact settings for each session that is passed to ApplyTo. ApplyTo sets the Poisson's ratio
   * of the settings to that of the responses. If null, the default, each session keeps its own
   * settings. */
  virtual void SetSettings(vtkContactSettings* settings);
  vtkContactSettings* GetSettings();
  ///@}

  /** Passes the output, the response of the chosen tool, Poisson's ratio, and the settings if
   * there are any, to a session. Applies the changes if the session runs. Returns false after
   * an error. */
  bool ApplyTo(vtkHapticSession* session);
  /** Passes the output to a scene, with the chosen tool in the state in which its response was
   * made. */
  void ShowIn(vtkContactScene* scene);

  vtkMTimeType GetMTime() override;

protected:
  vtkContactSetup();
  ~vtkContactSetup() override;

private:
  vtkContactSetup(const vtkContactSetup&) = delete;
  void operator=(const vtkContactSetup&) = delete;

  bool MakeRequest(palpate::ResponseRequest& request);
  bool TakeOver(palpate::MadeResponses&& made);

  int ChosenTool = 0;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double MaximumDeflection = 2.0;
  int Model = HalfSpace;
  double LayerThickness = 0.0;
  int LayerBase = 0;
  double BaseYoungsModulus = 1.0;
  double BasePoissonRatio = 0.45;
  bool BaseSlips = false;
  double ComplianceModulus = 0.0;
  bool CurvatureCorrection = true;
  bool EdgeCorrection = false;
  double MaximumTilt = 0.0;
  palpate::RelaxationList Relaxations;
  bool ComplianceRelaxes = true;
  bool Coupling = false;
  int StrainModel = 0;
  double StrainExponent = 2.0;
  double ErrorTolerance = 0.05;
  bool AutomaticTerms = false;
  double Tolerance = 0.0;
  double ChoiceDeflection = 0.0;
  vtkSmartPointer<vtkContactSettings> Settings;
  std::string Error;

  struct State;
  std::unique_ptr<State> Kept;
};

#endif
