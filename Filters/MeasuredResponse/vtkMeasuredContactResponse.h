// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeasuredContactResponse
 * @brief the response of any tool, from force-deflection curves measured with other tools
 *
 * Input: a body as for vtkToolContactResponse, and files of force-deflection curves taken at sites
 * of the body. Each file has the curves of one tool (`palpate/CurvesFile.h`; measured, or computed
 * by any finite-element code). Sites with the same name in several files are treated as one site
 * that was measured with several tools. Curves may also be given as tables with the columns of such
 * files, on the optional and repeatable input port 1. A table lacks the comments at the head of a
 * file, because a reader of .csv files omits them. Therefore the tool of a table is MeasuringTool,
 * and its curves count as measured.
 *
 * For each site the filter separates the loading branches, measures hysteresis and the effect of
 * speed, and determines the depth of first contact and the force before contact. Then it identifies
 * the simplest elastic body that explains the readings within their noise: a half-space (E*), a
 * half-space in series with a global compliance (E*, C_g), or a layer on a rigid base (E*, h). See
 * CurvePreparation.h and BodyIdentification.h.
 *
 * A relaxing body is identified if the curves of a site have times, and if a loop, a hold or an
 * effect of speed exceeds the limits. E* and the other parameters then describe the slow response.
 * In addition, the filter identifies strengths and times of up to four branches from loading, hold
 * and unloading together (RelaxingIdentification.h).
 *
 * A site is refused, with the reason, if
 * - it is not elastic and its curves have no times,
 * - no model fits its readings,
 * - it is farther from the surface than MaximumSiteDistance,
 * - its curves do not determine the parameters separately, such as those of a flat punch alone, or
 * - the signs or units of its curves are impossible (CurveSigns.h).
 *
 * A warning lists the refused sites. It is an error if all sites are refused.
 *
 * The response of any Tool is computed from the identified bodies. E*, C_g and 1/h are interpolated
 * over the surface (vtkShepardKernel) within Reach mm of a site, if the surface is connected to the
 * site and its normal is similar to that at the site. Therefore no value is transferred through a
 * thin lobe.
 *
 * Output port 0: the body with the response arrays of vtkToolContactResponse, and
 * - point data `IdentifiedModulus` (E* in MPa, 0 out of reach), `IdentifiedCompliance` (mm/N), and
 *   `IdentifiedThickness` (mm, 0 for a half-space), double;
 * - `Status` 4 OutOfReach at points that are out of reach of all sites: these points have no
 *   response;
 * - `Error` and `Validity` as in vtkToolContactResponse. The error at each sample includes the
 *   uncertainty at the sites (95 % intervals of the identified body, for this tool) and the
 *   differences between the sites around the point. For curvature and edges, it includes the
 *   difference between their effect on this tool and their effect in the readings;
 * - `Limit` 6 (data) if noise and the differences between sites are the largest part of the error.
 *   It is also set if, beyond Validity, the force or the contact radius of the tool (see DataEnd.h)
 *   exceeds that of every tool in the measurement;
 * - `RelaxationStrength` and `RelaxationTime` (field data), if a site relaxes. The curves are then
 *   the slow response. The strengths are the mean over the sites, at times that are common to the
 *   sites. If there are several sites, the point data `LocalRelaxation` has the strengths of the
 *   sites, interpolated like E*, 0 out of reach;
 * - field data `Model`: the identified bodies and their data. It contains `synthetic` if a file is
 *   synthetic.
 *
 * Output port 1: a vtkTable with a row per site: Site, Verdict (`identified`, or the reason of the
 * refusal), Model, Tools, X, Y, Z, Distance (mm, after registration), ReducedModulus, Compliance,
 * Thickness, ContactOffset, ForceOffset (N, at first contact) and ForceDrift (N/mm) of the first
 * tool, each with its 95 % confidence interval, Noise, Misfit, LargestForce (N), WithinNoise,
 * Hysteresis and RateEffect (fractions of the energy; NaN if not recorded). If a site relaxes also
 * HoldLoss (fraction of the force), RelaxationStrength and RelaxationTime 1 to 4 with their
 * intervals, and ShortestTime and LongestTime that the test can resolve (s). Remark: the number of
 * readings that MaximumStrain excludes, and the quantities that the readings do not determine.
 *
 * Output port 2: a vtkTable with a row per reading of a loading: Deflection (mm, from first
 * contact), Force (N, minus the identified offset and drift), MonotoneForce (isotonic regression),
 * ModelForce (N), Site, Tool. For a site that relaxes it has a row per reading of the whole test,
 * in the order of time, with Time (s); ModelForce is then computed for that history.
 *
 * @warning Assumes small strain, frictionless tools, and a body that is homogeneous under each
 * site. The response to the measuring tools identifies a body: E* of a site contains no information
 * about layers thinner than the largest measured contact radius. If there are too few readings
 * before the contact, forces are measured from zero and without drift (ArrangedReadings.h); Remark
 * then reports this.
 *
 * Cost: up to a tenth of a second per site, or a second for a site that relaxes, on all cores, in
 * addition to the cost of vtkToolContactResponse.
 *
 * @code{.py}
 * measured = palpate.vtkMeasuredContactResponse()
 * measured.SetInputConnection(surface.GetOutputPort())
 * measured.AddFileName("curves.csv")                   # readings, with the measuring tool
 * measured.SetTool(tool)                               # may differ from the measuring tool
 * measured.Update()
 * body = measured.GetOutput()
 * sites = measured.GetOutputDataObject(1)              # the body found at each site
 * @endcode
 *
 * @sa vtkToolContactResponse
 */
#ifndef vtkMeasuredContactResponse_h
#define vtkMeasuredContactResponse_h

#include "Response/Curves/RelaxationList.h" // For palpate::RelaxationList
#include "palpateMeasuredResponseModule.h"  // For export macro
#include "vtkToolFilter.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

namespace palpate
{
struct SiteMeasurement;
}

class PALPATEMEASUREDRESPONSE_EXPORT vtkMeasuredContactResponse : public vtkToolFilter
{
public:
  static vtkMeasuredContactResponse* New();
  vtkTypeMacro(vtkMeasuredContactResponse, vtkToolFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The files of curves. At least one is required unless there are tables. Read on every update.
   */
  void AddFileName(const std::string& fileName);
  void ClearFileNames();
  int GetNumberOfFileNames();
  std::string GetFileName(int index);
  ///@}

  /**
   * Adds a table of curves to input port 1. All its curves must have been taken with MeasuringTool.
   */
  void AddCurvesConnection(vtkAlgorithmOutput* table);

  ///@{
  /**
   * The tool of the tables on port 1, for example `sphere:6.35`. Required with tables. Default:
   * none.
   */
  vtkSetMacro(MeasuringTool, std::string);
  vtkGetMacro(MeasuringTool, std::string);
  ///@}

  ///@{
  /**
   * A file with the transformation from the instrument's frame to the body's frame: a rigid 4×4
   * matrix or pairs of points (SiteRegistration.h). Default: empty; then both frames are the same.
   */
  vtkSetMacro(RegistrationFile, std::string);
  vtkGetMacro(RegistrationFile, std::string);
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
  /** The model of every site, if it is known in advance. Default Automatic. */
  vtkSetClampMacro(BodyModel, int, Automatic, Layer);
  vtkGetMacro(BodyModel, int);
  ///@}

  ///@{
  /** Poisson's ratio, 0 to 0.5; used for layers only. Default 0.45. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** The contact of layers with their base: 0 Bonded (default) or 1 Slip. */
  vtkSetClampMacro(LayerBase, int, 0, 1);
  vtkGetMacro(LayerBase, int);
  ///@}

  ///@{
  /**
   * Whether to find the depth of first contact from the readings. Default on. Set it to off if
   * deflections are measured from first contact, as in finite-element results.
   */
  vtkSetMacro(FindContact, bool);
  vtkGetMacro(FindContact, bool);
  vtkBooleanMacro(FindContact, bool);
  ///@}

  ///@{
  /** Standard deviation of a force reading, N. Default 0: it is estimated from the readings. */
  vtkSetMacro(Noise, double);
  vtkGetMacro(Noise, double);
  ///@}

  ///@{
  /**
   * Largest fraction of the loading energy that an elastic body may lose on unloading. Default 0.2.
   * With a smaller value, weaker relaxation is also identified.
   */
  vtkSetMacro(MaximumHysteresis, double);
  vtkGetMacro(MaximumHysteresis, double);
  ///@}

  ///@{
  /**
   * Limit for an elastic body. It applies to the largest relative difference in energy between a
   * fast and a slow loading, and to the largest fraction by which the force may decrease during a
   * hold. Default 0.1.
   */
  vtkSetMacro(MaximumRateEffect, double);
  vtkGetMacro(MaximumRateEffect, double);
  ///@}

  ///@{
  /**
   * The relaxation of the body, if it is known in advance: E(t)/E∞ = 1 + Σ p exp(-t/τ). Each branch
   * has a strength p >= 0, relative to the slow modulus E∞, and a time τ > 0 in seconds. Up to four
   * branches are possible. The relaxation is then not identified; E* and the other parameters take
   * the speed of the test into account. Curves without times count as slow. Default: none.
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
   * Largest contact radius divided by tip radius up to which readings are used. This is the strain
   * measure of vtkToolContactResponse. The laws are those of small strain. Remark contains the
   * number of readings that are not used. Default 0.4.
   */
  vtkSetMacro(MaximumStrain, double);
  vtkGetMacro(MaximumStrain, double);
  ///@}

  ///@{
  /**
   * Largest residual of a model in excess of the noise, as a fraction of the largest force. Default
   * 0.02.
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
  /** Largest distance of a site from the surface, mm. Default 2. */
  vtkSetMacro(MaximumSiteDistance, double);
  vtkGetMacro(MaximumSiteDistance, double);
  ///@}

  ///@{
  /** Distance from a site up to which it determines the response of the surface, mm. Default 20. */
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /** As in vtkToolContactResponse. */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /** Largest tilt of the tool, degrees, as in vtkToolContactResponse. Default 0: upright. */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}

  ///@{
  /** As in vtkToolContactResponse. Defaults: 0.05 and on. */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  vtkSetMacro(StoreError, bool);
  vtkGetMacro(StoreError, bool);
  vtkBooleanMacro(StoreError, bool);
  ///@}

  ///@{
  /**
   * Results of the last update, mm: the root-mean-square distance between the pairs of points after
   * registration (NaN without pairs), and that of the sites from the surface.
   */
  vtkGetMacro(RegistrationResidual, double);
  vtkGetMacro(SiteResidual, double);
  ///@}

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
  std::string RespondTo(
    const palpate::SiteMeasurement& measurement, vtkPolyData* body, vtkPolyData* output);

  std::vector<std::string> FileNames;
  std::string MeasuringTool;
  std::string RegistrationFile;
  palpate::RelaxationList Relaxations;
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
  double ErrorTolerance = 0.05;
  bool StoreError = true;
  double MaximumTilt = 0.0;
  double RegistrationResidual = 0.0;
  double SiteResidual = 0.0;
};

#endif
