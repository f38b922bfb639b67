// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNoduleDetectability
 * @brief change of the force on tools due to nodules inside a body, at each point of its surface
 *
 * Input: a vtkUnstructuredGrid as in vtkElasticContactResponse, with the cell arrays of
 * vtkNoduleMaterial: `YoungsModulus` and `PoissonRatio`, and `YoungsModulusWithout` and
 * `PoissonRatioWithout` of the body without nodules. Arrays with other names are given as arrays to
 * process 0 to 3, in this order. A fault of the input is an error that names it. Empty input gives
 * empty output.
 *
 * Output: the body's outer surface as triangles, with the input's point arrays,
 * `OriginalPointIds`, and
 * - the response arrays of Tool on the body with nodules, as in vtkElasticContactResponse, and
 *   those of the tools of AddMoreTool under ResponseName followed by 2, 3 …; with StoreWithout also
 *   those on the body without nodules, with names that end in `Without`: "ResponseWithout",
 *   "Response2Without";
 * - point arrays with one component per tool, named by its specification: `ForceChange`, the
 *   largest relative change of the force by the nodules at equal depth, negative if the force
 *   decreases; `StiffnessChange`, the relative change of dF/dδ at that depth; `ChangeDepth`, that
 *   depth, mm; `Felt`, 1 if |ForceChange| is at least Threshold, else 0;
 * - `StrongestTool`: the number of the tool with the largest |ForceChange|, 0 for Tool; -1 if no
 *   change is known. This tool also detects the deepest nodules.
 *
 * The force is compared from the first sample to PressDepth, or to the end of the shorter response
 * (Range; with WithinValidity also Validity). If one body has no response at a point, the changes
 * are NaN and Felt is 0.
 *
 * **Threshold.** The smallest change of a force that a hand can perceive is about 7 % of it (Pang,
 * Tan and Durlach 1991, from 2.5 to 10 N, one-interval trials with feedback); it is between 0.07
 * and 0.1 for most people. The default of 0.1 is conservative. Forces below half a newton need a
 * larger change.
 *
 * **Accuracy.** The accuracy is that of vtkElasticContactResponse for either body. Errors that both
 * bodies share cancel, such as those of small strain and of elements far away. For the error due to
 * the mixed cells of a nodule see vtkNoduleMaterial.
 *
 * **Cost.** Two factorisations and twice the solutions of vtkElasticContactResponse, which are kept
 * for all tools until the input changes or a tool has a wider contact. A tool then takes a few
 * milliseconds per point. Without nodules a coarser spacing is often enough: SourceSpacingWithout
 * saves most of the second body's solutions. Abort is checked between steps and solutions. The
 * result is bit-identical for any number of threads.
 *
 * @code{.py}
 * felt = palpate.vtkNoduleDetectability()
 * felt.SetInputConnection(material.GetOutputPort())    # vtkNoduleMaterial
 * felt.SetTool(tool)
 * felt.AddMoreTool("flat:1.6")                         # radius in mm
 * felt.SetMaximumDeflection(1.0)                       # mm
 * felt.Update()
 * change = felt.GetOutput().GetPointData().GetArray("ForceChange")  # relative, one per tool
 * @endcode
 *
 * @sa vtkNoduleMaterial vtkElasticContactResponse
 */
#ifndef vtkNoduleDetectability_h
#define vtkNoduleDetectability_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkContactTool;
class vtkUnstructuredGrid;

namespace palpate
{
class SolvedBody;
struct SolveRequest;
} // namespace palpate

class PALPATESOLIDRESPONSE_EXPORT vtkNoduleDetectability : public vtkPolyDataAlgorithm
{
public:
  static vtkNoduleDetectability* New();
  vtkTypeMacro(vtkNoduleDetectability, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The first tool; required. A change of the tool also changes the modification time of this
   * filter.
   */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /**
   * Further tools, by their specification, such as "flat:1.6" (vtkContactTool::SetSpecification). A
   * wrong specification is an error when the filter runs.
   */
  void AddMoreTool(const std::string& specification);
  void RemoveAllMoreTools();
  int GetNumberOfTools() { return static_cast<int>(this->MoreTools.size()) + 1; }
  ///@}

  ///@{
  /** Smallest relative change of the force that counts as perceptible, positive. Default 0.1. */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /** Largest depth to which a hand presses, mm. Default 0: MaximumDeflection. */
  vtkSetMacro(PressDepth, double);
  vtkGetMacro(PressDepth, double);
  ///@}

  ///@{
  /**
   * Uses only depths at which the error of both responses is within ErrorTolerance. Default
   * off.
   */
  vtkSetMacro(WithinValidity, bool);
  vtkGetMacro(WithinValidity, bool);
  vtkBooleanMacro(WithinValidity, bool);
  ///@}

  ///@{
  /** Whether the responses of the body without nodules are stored, too. Default off. */
  vtkSetMacro(StoreWithout, bool);
  vtkGetMacro(StoreWithout, bool);
  vtkBooleanMacro(StoreWithout, bool);
  ///@}

  ///@{
  /** As in vtkElasticContactResponse. Defaults 2 mm, 8, "Response", 0.05. */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  ///@{
  /**
   * As in vtkElasticContactResponse, mm: the radius of the widest contact of all later tools.
   * Default 0.
   */
  vtkSetMacro(LargestContactRadius, double);
  vtkGetMacro(LargestContactRadius, double);
  ///@}

  ///@{
  /** As in vtkElasticContactResponse, mm: half the distance to the top of a nodule is enough.
   * Default 0: all points. */
  vtkSetMacro(SourceSpacing, double);
  vtkGetMacro(SourceSpacing, double);
  ///@}

  ///@{
  /** SourceSpacing for the body without nodules, mm: half the distance to a base or a layer is
   * enough. Default 0: as SourceSpacing. */
  vtkSetMacro(SourceSpacingWithout, double);
  vtkGetMacro(SourceSpacingWithout, double);
  ///@}

  ///@{
  /** As in vtkElasticCompliance, for each body: MiB, 0 (default): nine tenths of the available
   * memory. */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** As in vtkElasticCompliance: 0 Automatic (default), 1 Supernodal, 2 Simplicial. */
  vtkSetMacro(Solver, int);
  vtkGetMacro(Solver, int);
  ///@}

  ///@{
  /** Sums over both bodies of the values of vtkElasticContactResponse. */
  vtkGetMacro(MemoryEstimate, double);
  vtkGetMacro(NumberOfSolutions, vtkIdType);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkNoduleDetectability();
  ~vtkNoduleDetectability() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkNoduleDetectability(const vtkNoduleDetectability&) = delete;
  void operator=(const vtkNoduleDetectability&) = delete;

  std::string FindTools();
  std::string CheckTools();
  std::string Solve(vtkUnstructuredGrid* grid, bool& ended);
  std::string SolveOne(
    vtkUnstructuredGrid* grid, bool with, palpate::SolveRequest& request, bool& ended);
  std::string Compare(vtkUnstructuredGrid* grid, vtkPolyData* output);

  std::unique_ptr<palpate::SolvedBody> With;
  std::unique_ptr<palpate::SolvedBody> Without;
  vtkSmartPointer<vtkContactTool> Tool;
  std::vector<std::string> MoreTools;
  std::vector<vtkSmartPointer<vtkContactTool>> Tools; ///< tools of the current run
  double Threshold = 0.1;
  double PressDepth = 0.0;
  bool WithinValidity = false;
  bool StoreWithout = false;
  double MaximumDeflection = 2.0;
  int NumberOfSamples = 8;
  std::string ResponseName = "Response";
  double ErrorTolerance = 0.05;
  double LargestContactRadius = 0.0;
  double SourceSpacing = 0.0;
  double SourceSpacingWithout = 0.0;
  double MemoryLimit = 0.0;
  int Solver = 0;
  double MemoryEstimate = 0.0;
  vtkIdType NumberOfSolutions = 0;
};

#endif
