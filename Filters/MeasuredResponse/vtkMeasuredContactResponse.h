// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeasuredContactResponse
 * @brief the response of any tool from force-deflection curves measured with others
 *
 * Input: a body as for vtkToolContactResponse, and files of force-deflection curves taken at sites
 * of it, each file with one tool (`palpate/CurvesFile.h`; measured, or computed by any
 * finite-element code). Sites of one name in several files are one site, measured with several
 * tools. Curves also come as tables with the columns of such files, on the optional and repeatable
 * input port 1: a reader of .csv drops the comments in the head of a file, so the tool is
 * MeasuringTool, and the curves count as measured.
 *
 * For each site the loading branches are separated, hysteresis and the effect of speed are
 * measured, the depth of first contact and the force before it are found, and the simplest elastic
 * body that explains the readings within their noise is identified: a half-space (E*), one in
 * series with a global compliance (E*, C_g), or a layer on a rigid base (E*, h). See
 * CurvePreparation.h, BodyIdentification.h. A site that shows a loop, a hold or an effect of speed
 * beyond the limits, and whose curves have times, is identified as one that relaxes: E* and the
 * rest are then the slow response, and strengths and times of up to four branches come with it,
 * from loading, hold and unloading alike (RelaxingIdentification.h). A site is refused, with the
 * reason, when it is not elastic and has no times, not fitted by any model, farther from the
 * surface than MaximumSiteDistance, or when its curves do not tell the parameters apart, as those
 * of a flat punch alone, or have signs or units that cannot be (CurveSigns.h). Refused sites are
 * named in a warning; if none is left, that is an error.
 *
 * The response of any Tool follows from the identified bodies. E*, C_g and 1/h are interpolated
 * over the surface (vtkShepardKernel) within Reach mm of a site, where it is connected to the site
 * and faces the same way, so never across a thin lobe.
 *
 * Output port 0: the body with the response arrays of vtkToolContactResponse, and
 * - point data `IdentifiedModulus` (E* in MPa, 0 out of reach), `IdentifiedCompliance` (mm/N), and
 *   `IdentifiedThickness` (mm, 0 for a half-space), double;
 * - `Status` 4 OutOfReach where no site reaches: no response there;
 * - `Error` and `Validity` as in vtkToolContactResponse: at each sample, the uncertainty at the
 * sites (95 % intervals of the identified body, for this tool), how far the sites around differ
 * from one another, and the effect of curvature and edges as far as it differs from that in the
 * readings;
 * - `Limit` 6, data: noise and the differences of sites are the largest part; or beyond Validity
 * the tool presses harder (force) or strains more of the body (contact radius, see DataEnd.h) than
 * any tool did when it was measured;
 * - `RelaxationStrength` and `RelaxationTime` (field data), where a site relaxes; the curves are
 * then the slow response: the mean over the sites, at times that they share; with several sites
 * point data `LocalRelaxation`, their strengths interpolated as E* is, 0 out of reach;
 * - field data `Model`: what was identified, and from which data; it says `synthetic` if a file
 * does. Output port 1: a vtkTable, a row per site: Site, Verdict (`identified`, or why not), Model,
 * Tools, X, Y, Z, Distance (mm, after registration), ReducedModulus, Compliance, Thickness,
 * ContactOffset, ForceOffset (N, at first contact) and ForceDrift (N/mm) of the first tool, each
 * with its 95 % confidence interval, Noise, Misfit, LargestForce (N), WithinNoise, Hysteresis and
 * RateEffect (fractions of the energy; NaN where not recorded); where a site relaxes also HoldLoss
 * (fraction of the force), RelaxationStrength and RelaxationTime 1 to 4 with their intervals,
 * ShortestTime and LongestTime that the test can resolve (s); Remark: how many readings
 * MaximumStrain leaves out, and what the readings cannot tell. Output port 2: a vtkTable, a row per
 * reading of a loading: Deflection (mm, from first contact), Force (N, less the offset and drift
 * that were found), MonotoneForce (isotonic regression), ModelForce (N), Site, Tool; of a site
 * that relaxes a row per reading of the whole test, in the order of time, with Time (s), and
 * ModelForce along that history.
 *
 * @warning Small strain, frictionless tools, a body that is homogeneous under each site. A body is
 * identified by its behaviour under the measuring tools: E* of a site says nothing about layers
 * thinner than the contact radius that was reached. Where too few readings precede the contact,
 * forces count from zero, and as free of drift (ArrangedReadings.h); Remark says so.
 *
 * Cost: up to a tenth of a second per site, a second where it relaxes, on all cores, then that of
 * vtkToolContactResponse.
 *
 * @sa vtkToolContactResponse
 */
#ifndef vtkMeasuredContactResponse_h
#define vtkMeasuredContactResponse_h

#include "Response/Curves/RelaxationList.h" // For palpate::RelaxationList
#include "palpateMeasuredResponseModule.h"  // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkContactTool;

namespace palpate
{
struct SiteMeasurement;
}

class PALPATEMEASUREDRESPONSE_EXPORT vtkMeasuredContactResponse : public vtkPolyDataAlgorithm
{
public:
  static vtkMeasuredContactResponse* New();
  vtkTypeMacro(vtkMeasuredContactResponse, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The files of curves; at least one unless there are tables. They are read on every update. */
  void AddFileName(const std::string& fileName);
  void ClearFileNames();
  int GetNumberOfFileNames();
  std::string GetFileName(int index);
  ///@}

  /** Adds a table of curves, all taken with MeasuringTool, to input port 1. */
  void AddCurvesConnection(vtkAlgorithmOutput* table);

  ///@{
  /** The tool of the tables on port 1, as `sphere:6.35`; required with them. Default: none. */
  vtkSetMacro(MeasuringTool, std::string);
  vtkGetMacro(MeasuringTool, std::string);
  ///@}

  ///@{
  /**
   * A file that carries the instrument's frame to the body's: a rigid 4×4 matrix or pairs of points
   * (SiteRegistration.h). Empty, the default: the frames are the same.
   */
  vtkSetMacro(RegistrationFile, std::string);
  vtkGetMacro(RegistrationFile, std::string);
  ///@}

  ///@{
  /** The tool of the response; required. Its changes count in this filter's modification time. */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  /// Values of BodyModel.
  enum BodyModelType
  {
    Automatic = 0,
    HalfSpace = 1,
    GlobalCompliance = 2,
    Layer = 3
  };

  ///@{
  /** The model of every site, if it is known from elsewhere. Default Automatic. */
  vtkSetClampMacro(BodyModel, int, Automatic, Layer);
  vtkGetMacro(BodyModel, int);
  ///@}

  ///@{
  /** Poisson's ratio, 0 to 0.5; matters to layers only. Default 0.45. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** How layers rest on their base: 0 Bonded (default) or 1 Slip. */
  vtkSetClampMacro(LayerBase, int, 0, 1);
  vtkGetMacro(LayerBase, int);
  ///@}

  ///@{
  /**
   * Whether to find the depth of first contact from the readings. Default on; off where deflections
   * are measured from first contact, as by finite elements.
   */
  vtkSetMacro(FindContact, bool);
  vtkGetMacro(FindContact, bool);
  vtkBooleanMacro(FindContact, bool);
  ///@}

  ///@{
  /** Standard deviation of a reading of force, N. 0, the default: estimated from the readings. */
  vtkSetMacro(Noise, double);
  vtkGetMacro(Noise, double);
  ///@}

  ///@{
  /**
   * Largest fraction of the loading's energy that an elastic body may lose by unloading. Default
   * 0.2; a smaller value lets weaker relaxation be identified.
   */
  vtkSetMacro(MaximumHysteresis, double);
  vtkGetMacro(MaximumHysteresis, double);
  ///@}

  ///@{
  /**
   * Of an elastic body, the largest relative difference in energy between a fast and a slow
   * loading, and the largest fraction of its force that a hold may lose. Default 0.1.
   */
  vtkSetMacro(MaximumRateEffect, double);
  vtkGetMacro(MaximumRateEffect, double);
  ///@}

  ///@{
  /**
   * How the body relaxes, if that is known from elsewhere: E(t)/E∞ = 1 + Σ p exp(-t/τ), each branch
   * with its strength p >= 0, relative to the slow modulus E∞, and its time τ > 0 in seconds; up to
   * four. Then it is not identified, and the speed of the test is taken into account in E* and the
   * rest; curves without times count as slow. Default none.
   */
  void AddRelaxation(double strength, double seconds)
  {
    this->Relaxations.add(strength, seconds);
    this->Modified();
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
  ///@}

  ///@{
  /**
   * Contact radius over tip radius up to which readings are used, the strain measure of
   * vtkToolContactResponse; the laws are those of small strain. How many are left out stands in
   * Remark. Default 0.4.
   */
  vtkSetMacro(MaximumStrain, double);
  vtkGetMacro(MaximumStrain, double);
  ///@}

  ///@{
  /**
   * Largest residual of a model beyond the noise, as a fraction of the largest force. Default 0.02.
   */
  vtkSetMacro(MaximumMisfit, double);
  vtkGetMacro(MaximumMisfit, double);
  ///@}

  ///@{
  /** Largest half-width of the confidence interval of E*, relative. Default 0.5. */
  vtkSetMacro(MaximumUncertainty, double);
  vtkGetMacro(MaximumUncertainty, double);
  ///@}

  ///@{
  /** How far a site may lie from the surface, mm. Default 2. */
  vtkSetMacro(MaximumSiteDistance, double);
  vtkGetMacro(MaximumSiteDistance, double);
  ///@}

  ///@{
  /** Radius around a site within which it determines the surface, mm. Default 20. */
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /** As of vtkToolContactResponse. */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /** How far the tool will be tilted, degrees, as in vtkToolContactResponse. Default
   * 0: upright. */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}

  ///@{
  /** As of vtkToolContactResponse. Default 0.05, and on. */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  vtkSetMacro(StoreError, bool);
  vtkGetMacro(StoreError, bool);
  vtkBooleanMacro(StoreError, bool);
  ///@}

  ///@{
  /**
   * Of the last update: root-mean-square distance between the pairs of points after registration
   * (NaN unless registered by pairs), and of the sites from the surface, mm.
   */
  vtkGetMacro(RegistrationResidual, double);
  vtkGetMacro(SiteResidual, double);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkMeasuredContactResponse();
  ~vtkMeasuredContactResponse() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkMeasuredContactResponse(const vtkMeasuredContactResponse&) = delete;
  void operator=(const vtkMeasuredContactResponse&) = delete;

  std::string CheckProperties();
  std::string ReadSites(vtkInformationVector* tables, palpate::SiteMeasurement& measurement);
  bool IdentifySites(palpate::SiteMeasurement& measurement);
  std::string JudgeSites(const palpate::SiteMeasurement& measurement);
  bool RespondTo(
    const palpate::SiteMeasurement& measurement, vtkPolyData* body, vtkPolyData* output);

  std::vector<std::string> FileNames;
  std::string MeasuringTool;
  std::string RegistrationFile;
  palpate::RelaxationList Relaxations;
  vtkSmartPointer<vtkContactTool> Tool;
  int BodyModel = Automatic;
  double PoissonRatio = 0.45;
  int LayerBase = 0;
  bool FindContact = true;
  double Noise = 0.0;
  double MaximumHysteresis = 0.2;
  double MaximumRateEffect = 0.1;
  double MaximumStrain = 0.4;
  double MaximumMisfit = 0.02;
  double MaximumUncertainty = 0.5;
  double MaximumSiteDistance = 2.0;
  double Reach = 20.0;
  double MaximumDeflection = 2.0;
  int NumberOfSamples = 8;
  std::string ResponseName = "Response";
  double ErrorTolerance = 0.05;
  bool StoreError = true;
  double MaximumTilt = 0.0;
  double RegistrationResidual = 0.0;
  double SiteResidual = 0.0;
};

#endif
