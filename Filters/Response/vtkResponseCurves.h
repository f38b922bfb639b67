// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseCurves
 * @brief the stored force-deflection curves of chosen points, as a table to plot
 *
 * Input: a body with response arrays. Output: a vtkTable with column `Deflection (mm)`, from 0 to
 * the largest Range of the chosen points in NumberOfRows steps, and one column of force in N per
 * point, named `<ResponseName> at point <id> (N)` and evaluated as the kernel does. Beyond a
 * point's Range the column is NaN. A point without response, or an id out of range, is an error
 * naming it.
 */
#ifndef vtkResponseCurves_h
#define vtkResponseCurves_h

#include "palpateResponseModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For std::string
#include <vector> // For std::vector

class PALPATERESPONSE_EXPORT vtkResponseCurves : public vtkTableAlgorithm
{
public:
  static vtkResponseCurves* New();
  vtkTypeMacro(vtkResponseCurves, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The chosen points, in the order of the columns. Default: none, which gives an empty table. */
  void AddPointId(vtkIdType id);
  void RemoveAllPointIds();
  ///@}

  ///@{
  /** Rows of the table, at least 2. Default 101. */
  vtkSetClampMacro(NumberOfRows, int, 2, 1000000);
  vtkGetMacro(NumberOfRows, int);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

protected:
  vtkResponseCurves() = default;
  ~vtkResponseCurves() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkResponseCurves(const vtkResponseCurves&) = delete;
  void operator=(const vtkResponseCurves&) = delete;

  std::vector<vtkIdType> PointIds;
  int NumberOfRows = 101;
  std::string ResponseName = "Response";
};

#endif
