// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactSetup
 * @brief what is touched with what: body, tools, material, model, and the responses that follow
 *
 * Give it a bare body and tools and say what the body is made of; Update makes the responses of all
 * tools, each under a prefix of its own: `Response` for the first, then `Response2`, `Response3`...
 * GetOutput is the body with them, GetTool and GetResponseName say whose they are. ApplyTo gives
 * them to a session, running or not, ShowIn to a scene.
 *
 * Under a hand nothing may wait for that (a second for some hundred thousand points). Request makes
 * the responses, and what the session makes of them, on a thread of its own; of several requests
 * the newest wins; Collect, called once a frame, takes them over when they are there. Until then,
 * and after an error, output, session and scene stay as they are.
 *
 * Lengths in mm, moduli in MPa. The body is not written to; its points and cells must not be
 * changed in place once it has been given (SetBody again, after changes). For one thread, the
 * graphics thread; only Update waits.
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
    Layer = 1,  ///< the property LayerThickness, or the array (mm); on LayerBase, or AddLayer's
    Series = 2, ///< local, in series with the array GlobalCompliance (mm/N)
    Stored = 3  ///< the body brings its responses: they are used as they are
  };

  ///@{
  /** The body: triangles, outward normals if it has any; with the arrays its models need. */
  void SetBody(vtkPolyData* body);
  vtkPolyData* GetBody();
  ///@}

  ///@{
  /** The tools; changing one counts as a change of the setup. With Stored they are what is drawn.
   */
  void AddTool(vtkContactTool* tool);
  void RemoveAllTools();
  int GetNumberOfTools();
  /** Null where there is none. */
  vtkContactTool* GetTool(int tool);
  /** Prefix of its response arrays. */
  std::string GetResponseName(int tool);
  ///@}

  ///@{
  /** The tool in the hand, from 0, and itself, or null where there is none. Choosing another needs
   * no new responses. Default 0. */
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
  /** Poisson's ratio, 0 to 0.5. Default 0.45. With Series the compliance stays the one it is. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}
  ///@{
  /** Depth of the last sample, mm, > 0. Default 2. */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  ///@}

  ///@{
  /** What lies under the surface: see above. Default HalfSpace. */
  vtkSetMacro(Model, int);
  vtkGetMacro(Model, int);
  ///@}
  /** Whether the body and the properties have what a model needs; Stored and the others exclude
   * each other. */
  bool HasModel(int model);
  ///@{
  /** Thickness of the layer, mm, the same everywhere. Default 0: as the array of this name says. */
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  ///@}
  ///@{
  /** Layers below that one, as vtkToolContactResponse has them, for the model Layer; a thickness of
   * 0 is as the point array LayerThickness1 says (of the second layer only), and LayerThickness 0
   * then as LayerThickness0 does. Default none. */
  void AddLayer(double thickness, double youngsModulus, double poissonRatio, bool slips = false);
  void ClearLayers();
  int GetNumberOfAddedLayers();
  ///@}
  ///@{
  /** How the layers rest, as LayerBase of vtkToolContactResponse: 0 bonded to a rigid base
   * (default), 1 slipping on it, 2 on an elastic half-space, of this modulus (MPa) and Poisson's
   * ratio, default 1 and 0.45, which they may slip on, too. */
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
  /** Young's modulus (MPa) at which GlobalCompliance and the global modes of the body were found:
   * for another they are scaled. Default 0: they hold as they are, whatever the modulus. */
  vtkSetMacro(ComplianceModulus, double);
  vtkGetMacro(ComplianceModulus, double);
  ///@}

  ///@{
  /** Whether the body's sag under the tool counts; see vtkToolContactResponse. Default on. */
  vtkSetMacro(CurvatureCorrection, bool);
  vtkGetMacro(CurvatureCorrection, bool);
  vtkBooleanMacro(CurvatureCorrection, bool);
  ///@}
  ///@{
  /** Whether sharp edges are felt; see vtkToolContactResponse. Default off. */
  vtkSetMacro(EdgeCorrection, bool);
  vtkGetMacro(EdgeCorrection, bool);
  vtkBooleanMacro(EdgeCorrection, bool);
  ///@}
  ///@{
  /** How far the tools will be tilted, degrees; see vtkToolContactResponse. Default 0: upright. */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}
  ///@{
  /** Whether several tools at once feel one another; see vtkToolContactResponse. Default off. */
  vtkSetMacro(Coupling, bool);
  vtkGetMacro(Coupling, bool);
  vtkBooleanMacro(Coupling, bool);
  ///@}
  ///@{
  /** How the body relaxes, up to four branches of strength and time (s), and whether the global
   * compliance of Series does, too; see vtkToolContactResponse. A strength of 0 is none. Default
   * none, and on. */
  void AddRelaxation(double strength, double seconds)
  {
    this->Relaxations.add(strength, seconds);
    this->Modified();
  }
  /** Strength and time of a branch, from 0; the index after the last adds one. */
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
  /** How the body resists large strain, a value of vtkToolContactResponse::StrainModelType.
   * Default SmallStrain. */
  vtkSetClampMacro(StrainModel, int, 0, 3);
  vtkGetMacro(StrainModel, int);
  ///@}
  ///@{
  /** The exponent of Ogden's or Demiray's law. Default 2. */
  vtkSetMacro(StrainExponent, double);
  vtkGetMacro(StrainExponent, double);
  ///@}
  ///@{
  /** The estimated relative error that the responses are valid to; 0: where the first assumption
   * breaks, without an error. Default 0.05. */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  ///@}
  ///@{
  /** Whether the law has no more than the forces need, within Tolerance (0: 1 %); see
   * vtkToolContactResponse. Default off. */
  vtkSetMacro(AutomaticTerms, bool);
  vtkGetMacro(AutomaticTerms, bool);
  vtkBooleanMacro(AutomaticTerms, bool);
  ///@}

  ///@{
  /** Largest error of the force, relative, at which a session is given a simpler form of a response
   * than a curve per point (vtkResponseChoice, and what that means by it). Default 0: responses are
   * felt as they are. The output has them whole in any case. */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}
  ///@{
  /** How deep the form is chosen for, mm, where there is a Tolerance. Default 0: half of
   * MaximumDeflection. */
  vtkSetMacro(ChoiceDeflection, double);
  vtkGetMacro(ChoiceDeflection, double);
  ///@}

  /** Makes the responses now. Returns false after an error, with the output as it was. */
  bool Update();
  /** Has them made in the background, unless they are, or are being made, as everything is set now.
   */
  void Request();
  /** Whether what was requested is not there yet. */
  bool IsBusy();
  /** Takes over what was requested, if it is there: true once. False, after an error, if it could
   * not be made. Never waits. */
  bool Collect();
  /** The newest error; "" after a success. */
  vtkGetMacro(Error, std::string);

  /** The body with the responses; null before the first. A new one each time. */
  vtkPolyData* GetOutput();
  /** The tool its response was made for; null before the first Update or Collect. */
  vtkContactTool* GetOutputTool(int tool);

  /** Which form of a tool's response is felt, and why, in a sentence; "" without a Tolerance and
   * before the first Update or Collect. */
  std::string GetChoice(int tool);

  /** Largest force of any tool of the output at any point, MaximumDeflection deep, N; 0 before the
   * first. */
  double GetLargestForce();

  ///@{
  /** How the contact feels in every session that this is applied to; Poisson's ratio in it becomes
   * that of the responses then. Default null: each session keeps its own settings. */
  virtual void SetSettings(vtkContactSettings* settings);
  vtkContactSettings* GetSettings();
  ///@}

  /** Gives a session the output, the response of the tool in the hand, the settings if there are
   * any, and Poisson's ratio, and applies it if it runs. Returns false after an error. */
  bool ApplyTo(vtkHapticSession* session);
  /** Gives a scene the output and the tool in the hand as its response was made. */
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
