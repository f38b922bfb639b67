// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNoduleDetectability
 * @brief computes the change of the force on tools due to nodules inside a body, at each point of
 *   its surface
 *
 * Input: a vtkUnstructuredGrid as in vtkElasticContactResponse, with the cell arrays of
 * vtkNoduleMaterial: `YoungsModulus` and `PoissonRatio`, and `YoungsModulusWithout` and
 * `PoissonRatioWithout` for the body without nodules. Arrays with other names can be set as arrays
 * to process 0 to 3, in this order. Invalid input raises an error that names the fault. Empty input
 * gives empty output.
 *
 * Output: the body's outer surface as triangles, with the input's point arrays,
 * `OriginalPointIds`, and
 * - the response arrays of Tool on the body with nodules, as in vtkElasticContactResponse. The
 *   prefix for the tools of AddMoreTool is ResponseName followed by 2, 3 … With StoreWithout, the
 *   output also has the responses on the body without nodules, with prefixes such as
 *   "ResponseWithout" and "Response2Without";
 * - point arrays with one component per tool. The name of a component is the specification of the
 *   tool. `ForceChange` is the largest relative change of the force by the nodules at equal depth,
 *   negative if the force decreases. `ChangeDepth` is the depth of this change, mm.
 *   `StiffnessChange` is the relative change of dF/dδ at this depth. `Felt` is 1 if |ForceChange|
 *   is at least Threshold, else 0;
 * - `StrongestTool`: the number of the tool with the largest |ForceChange|, 0 for Tool; -1 if no
 *   change is known. The tool with the largest change also detects the deepest nodules.
 *
 * The force is compared from the first sample to PressDepth, or to the end of the shorter response
 * (Range; with WithinValidity also Validity). If one of the two bodies has no response at a point,
 * the changes are NaN and Felt is 0.
 *
 * **Threshold.** The smallest change of a force that a hand can perceive is about 7 % of the force
 * (Pang, Tan and Durlach 1991, from 2.5 to 10 N, one-interval trials with feedback). For most
 * people, the threshold is between 0.07 and 0.1. The default of 0.1 is conservative. Forces below
 * half a newton need a larger change.
 *
 * **Accuracy.** The accuracy is that of vtkElasticContactResponse for either body. Errors that both
 * bodies share cancel, such as those of small strain and of distant elements. For the error due to
 * the mixed cells of a nodule see vtkNoduleMaterial.
 *
 * **Cost.** The filter needs two factorisations and twice the solutions of
 * vtkElasticContactResponse. They are kept for all tools until the input changes or a tool has a
 * wider contact. A further tool takes a few milliseconds per point. Without nodules, a coarser
 * spacing is often sufficient. SourceSpacingWithout then saves most of the solutions of the second
 * body. Abort is checked between steps and solutions. The result is bit-identical for any number of
 * threads.
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
   * The first tool. It is required. A change of the tool also changes the modification time of this
   * filter.
   */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /**
   * Adds a further tool by its specification, such as "flat:1.6"
   * (vtkContactTool::SetSpecification). An invalid specification is an error when the filter runs.
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
  /** Largest depth to which a hand presses, mm. The default 0 selects MaximumDeflection. */
  vtkSetMacro(PressDepth, double);
  vtkGetMacro(PressDepth, double);
  ///@}

  ///@{
  /**
   * Whether only depths are used at which the error of both responses is within ErrorTolerance.
   * Default off.
   */
  vtkSetMacro(WithinValidity, bool);
  vtkGetMacro(WithinValidity, bool);
  vtkBooleanMacro(WithinValidity, bool);
  ///@}

  ///@{
  /** Whether the output also contains the responses on the body without nodules. Default off. */
  vtkSetMacro(StoreWithout, bool);
  vtkGetMacro(StoreWithout, bool);
  vtkBooleanMacro(StoreWithout, bool);
  ///@}

  ///@{
  /**
   * Same as in vtkElasticContactResponse. The defaults are 2 mm, 8 samples, "Response" and 0.05.
   */
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
   * Same as in vtkElasticContactResponse, mm. Set it to the radius of the widest contact of all
   * later tools. Default 0.
   */
  vtkSetMacro(LargestContactRadius, double);
  vtkGetMacro(LargestContactRadius, double);
  ///@}

  ///@{
  /**
   * Same as in vtkElasticContactResponse, mm. Half the distance to the top of a nodule is
   * sufficient. The default 0 selects all points.
   */
  vtkSetMacro(SourceSpacing, double);
  vtkGetMacro(SourceSpacing, double);
  ///@}

  ///@{
  /**
   * SourceSpacing for the body without nodules, mm. Half the distance to a base or a layer is
   * sufficient. The default 0 selects the value of SourceSpacing.
   */
  vtkSetMacro(SourceSpacingWithout, double);
  vtkGetMacro(SourceSpacingWithout, double);
  ///@}

  ///@{
  /**
   * Same as in vtkElasticCompliance, for each of the two bodies, MiB. The default 0 allows nine
   * tenths of the available memory.
   */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** Same as in vtkElasticCompliance: 0 Automatic (default), 1 Supernodal, 2 Simplicial. */
  vtkSetMacro(Solver, int);
  vtkGetMacro(Solver, int);
  ///@}

  ///@{
  /** Sums of the values of vtkElasticContactResponse over both bodies. */
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
