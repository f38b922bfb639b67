// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactSetup
 * @brief body, tools, material and model of a contact, and the responses made from them
 *
 * Set tools, a body without responses, and the material of the body. Update makes the responses of
 * all tools, each under its own prefix: `Response` for the first, then `Response2`, `Response3`...
 * GetOutput is the body with the responses. GetTool and GetResponseName give the tool and the
 * prefix of each. ApplyTo passes them to a session, running or not; ShowIn passes them to a scene.
 *
 * Making responses takes a second for a few hundred thousand points, and a live session must not
 * wait for that. Request makes the responses, and the kernels for the session, on another thread.
 * Only the newest of several requests is carried out. Collect, called once a frame, takes over the
 * finished responses. Until then, and after an error, output, session and scene do not change.
 *
 * Another Young's modulus scales the responses instead, within 50 ms, unless other moduli of the
 * body stay. Another Poisson's ratio of a HalfSpace scales the forces as fast; then errors and
 * validities are computed in the background, IsBusy is true, and a second Collect takes them over.
 *
 * Lengths in mm, moduli in MPa. The body is not modified. Its points and cells must not be changed
 * in place after SetBody (after changes, call SetBody again). Only one thread, the graphics thread,
 * may use it; only Update blocks that thread.
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
    Layer = 1,  ///< a layer whose thickness is the property LayerThickness, or the array of this
                ///< name (mm); below it are the layers of AddLayer, if any, and LayerBase
    Series = 2, ///< the local deflection in series with the array GlobalCompliance (mm/N)
    Stored = 3  ///< the body has its responses already: they are used unchanged
  };

  ///@{
  /**
   * The body: triangles, with outward normals if it has any, and the arrays that the models need.
   */
  void SetBody(vtkPolyData* body);
  vtkPolyData* GetBody();
  ///@}

  ///@{
  /** The tools. A change of a tool counts as a change of the setup. With Stored, the tools are only
   * drawn. */
  void AddTool(vtkContactTool* tool);
  void RemoveAllTools();
  int GetNumberOfTools();
  /** The tool of this index; null if there is none. */
  vtkContactTool* GetTool(int tool);
  /** Prefix of the response arrays of a tool. */
  std::string GetResponseName(int tool);
  ///@}

  ///@{
  /** The chosen tool, by its index from 0. GetTool of that index returns the tool itself, or null.
   * Choosing another tool needs no new responses. Default 0. */
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
   * Poisson's ratio, 0 to 0.5. Default 0.45. With Series the compliance does not change with it.
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
  /** The model of the body below the surface, see above. Default HalfSpace. */
  vtkSetMacro(Model, int);
  vtkGetMacro(Model, int);
  ///@}
  /** Whether the body and the properties have the data that a model needs. Stored and the other
   * models exclude each other. */
  bool HasModel(int model);
  ///@{
  /**
   * Thickness of the layer, mm, the same everywhere. Default 0: the array LayerThickness gives it.
   */
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  ///@}
  ///@{
  /** Layers below the first one, for the model Layer, as in vtkToolContactResponse. Thickness 0 is
   * only possible for the first of them: the point array LayerThickness1 gives its thickness. With
   * added layers, LayerThickness 0 means the array LayerThickness0. Default none. */
  void AddLayer(double thickness, double youngsModulus, double poissonRatio, bool slips = false);
  void ClearLayers();
  int GetNumberOfAddedLayers();
  ///@}
  ///@{
  /** The base of the layers, as LayerBase of vtkToolContactResponse: 0 bonded to a rigid base
   * (default), 1 slipping on a rigid base, 2 on an elastic half-space. The half-space has this
   * Young's modulus (MPa, default 1) and Poisson's ratio (default 0.45); the layers may slip on it.
   * */
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
   * computed. For another modulus they are scaled. Default 0: they are used unchanged for any
   * modulus. */
  vtkSetMacro(ComplianceModulus, double);
  vtkGetMacro(ComplianceModulus, double);
  ///@}

  ///@{
  /** Whether the body's sag under the tool is included; see vtkToolContactResponse. Default on. */
  vtkSetMacro(CurvatureCorrection, bool);
  vtkGetMacro(CurvatureCorrection, bool);
  vtkBooleanMacro(CurvatureCorrection, bool);
  ///@}
  ///@{
  /** Whether sharp edges change the force; see vtkToolContactResponse. Default off. */
  vtkSetMacro(EdgeCorrection, bool);
  vtkGetMacro(EdgeCorrection, bool);
  vtkBooleanMacro(EdgeCorrection, bool);
  ///@}
  ///@{
  /** Largest tilt of the tools, degrees; see vtkToolContactResponse. Default 0: upright. */
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
  /** Relaxation of the body: up to four branches of strength and time (s), and whether the global
   * compliance of Series relaxes, too; see vtkToolContactResponse. A branch of strength 0 has no
   * effect. Default: no branches, and on. */
  void AddRelaxation(double strength, double seconds)
  {
    this->Relaxations.add(strength, seconds);
    this->Modified();
  }
  /** Sets strength and time of a branch, from 0. The index after the last adds a branch. */
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
  /** The estimated relative error up to which the responses are valid. 0: they are valid until the
   * first assumption fails, without an estimate of the error. Default 0.05. */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  ///@}
  ///@{
  /** Whether the law has only the terms that the forces need, within Tolerance (0: 1 %); see
   * vtkToolContactResponse. Default off. */
  vtkSetMacro(AutomaticTerms, bool);
  vtkGetMacro(AutomaticTerms, bool);
  vtkBooleanMacro(AutomaticTerms, bool);
  ///@}

  ///@{
  /** Largest relative error of the force for which a session gets a simpler form of a response than
   * a curve per point; vtkResponseChoice defines this error. Default 0: responses are used
   * unchanged. The output always has the full responses. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}
  ///@{
  /** Deflection for which the form is chosen, mm, if there is a Tolerance. Default 0: half of
   * MaximumDeflection. */
  vtkSetMacro(ChoiceDeflection, double);
  vtkGetMacro(ChoiceDeflection, double);
  ///@}

  /** Makes the responses now, on the calling thread and with its priority; ProgressEvent reports
   * the fraction that is done (double). Returns false after an error; the output is then unchanged.
   */
  bool Update();
  /** Makes the responses in the background, with a lower priority, unless they exist, or are being
   * made, for the present settings. */
  void Request();
  /** Whether the requested responses are not ready yet. */
  bool IsBusy();
  /** Fraction of the requested work that is done, 0 to 1; 1 if nothing is requested. */
  double GetProgress();
  /** While the requested responses are not ready: a sentence about the forces that are still shown,
   * "Computing: still the force of E = 35 kPa"; "" otherwise. */
  std::string GetPendingText();
  /** Withdraws the request. Young's modulus, Poisson's ratio, model, relaxations and the sizes of
   * the tools return to those of the output. No effect if nothing is requested. */
  void Cancel();
  /** Takes over the requested responses if they are ready. Returns true once, and a second time
   * after another Poisson's ratio of a HalfSpace. Returns false, after an error, if they could not
   * be made. Never waits. */
  bool Collect();
  /** The error of the newest request; "" after a success. */
  vtkGetMacro(Error, std::string);

  /**
   * The body with the responses; null before the first Update or Collect. A new object each time.
   */
  vtkPolyData* GetOutput();
  /** The tool for which a response was made; null before the first Update or Collect. */
  vtkContactTool* GetOutputTool(int tool);

  /** A sentence with the form of a tool's response in use, and the reason for it; "" without a
   * Tolerance, and before the first Update or Collect. */
  std::string GetChoice(int tool);

  /** Largest force of any tool of the output at any point, at MaximumDeflection, N; 0 before the
   * first Update or Collect. */
  double GetLargestForce();

  ///@{
  /** The contact settings of every session that is passed to ApplyTo. ApplyTo sets their Poisson's
   * ratio to that of the responses. Default null: each session keeps its own settings. */
  virtual void SetSettings(vtkContactSettings* settings);
  vtkContactSettings* GetSettings();
  ///@}

  /** Passes the output, the response of the chosen tool, Poisson's ratio, and the settings if there
   * are any, to a session. If the session runs, applies the changes. Returns false after an error.
   * */
  bool ApplyTo(vtkHapticSession* session);
  /** Passes the output to a scene, and the chosen tool as it was when its response was made. */
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
