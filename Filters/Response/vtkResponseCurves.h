// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseCurves
 * @brief the stored force-deflection curves of chosen points, as a table to plot
 *
 * Input port 0: a body with response arrays. Input port 1, optional: a vtkSelection of points of
 * the body, of any type that vtkExtractSelection supports, such as indices, thresholds, locations
 * or a frustum. Selected cells select their points. With a selection, PointIds is ignored.
 *
 * Output: a vtkTable. The column `Deflection (mm)` goes from 0 to the largest Range of the chosen
 * points in NumberOfRows steps. The next columns contain the force in N, one column per response
 * and point, named `<response> at point <id> (N)`. The force is evaluated as in the kernel. Beyond
 * the Range of a point, the column is NaN. If the response stores its error and ErrorBand is on,
 * two more columns per response and point follow after all force columns. They contain the bounds
 * of the force by its estimated error: `<response> at point <id>, least (N)` and `<response> at
 * point <id>, most (N)`.
 *
 * A point of PointIds that has no response, or whose id is out of range, is an error that names the
 * point. Selected points without response are left out, and one warning gives their number. If no
 * point is left, this is an error. If more than MaximumNumberOfPoints points are selected, only
 * MaximumNumberOfPoints of them are used, evenly spaced among their ids, with a warning. An empty
 * selection, or no PointIds, gives an empty table.
 *
 * @code{.py}
 * curves = palpate.vtkResponseCurves()
 * curves.SetInputData(body)
 * curves.AddPointId(0)
 * curves.SetNumberOfRows(50)
 * curves.Update()
 * table = curves.GetOutput()                           # Deflection (mm), Response at point 0 (N)
 * @endcode
 */
#ifndef vtkResponseCurves_h
#define vtkResponseCurves_h

#include "palpateResponseModule.h" // For export macro
#include "vtkSmartPointer.h"       // For vtkSmartPointer
#include "vtkTableAlgorithm.h"

#include <string> // For std::string
#include <vector> // For std::vector

class vtkExtractSelection;
class vtkPolyData;
class vtkSelection;

class PALPATERESPONSE_EXPORT vtkResponseCurves : public vtkTableAlgorithm
{
public:
  static vtkResponseCurves* New();
  vtkTypeMacro(vtkResponseCurves, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The chosen points, in the order of the columns. By default no point is chosen, which gives an
   * empty table.
   */
  void AddPointId(vtkIdType id);
  void RemoveAllPointIds();
  ///@}

  /** Sets the selection, input port 1. */
  void SetSelectionConnection(vtkAlgorithmOutput* selection);

  /**
   * The filter that finds the selected points. The default is a vtkExtractSelection. An application
   * with other types of selection sets its own filter. Only the inputs of this filter are changed.
   */
  void SetSelectionExtractor(vtkExtractSelection* extractor);

  ///@{
  /** Largest number of points of a selection, at least 1. Default 20. */
  vtkSetClampMacro(MaximumNumberOfPoints, int, 1, 10000);
  vtkGetMacro(MaximumNumberOfPoints, int);
  ///@}

  ///@{
  /** Number of rows of the table, at least 2. Default 101. */
  vtkSetClampMacro(NumberOfRows, int, 2, 1000000);
  vtkGetMacro(NumberOfRows, int);
  ///@}

  ///@{
  /** Prefix of the response arrays. Default "Response". */
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /**
   * Additional responses for the same table, after ResponseName. A repeated name is ignored. By
   * default there are none.
   */
  void AddMoreResponseName(const std::string& name);
  void RemoveAllMoreResponseNames();
  ///@}

  ///@{
  /** Whether the table has columns for the bounds of each force. Default on. */
  vtkSetMacro(ErrorBand, bool);
  vtkGetMacro(ErrorBand, bool);
  vtkBooleanMacro(ErrorBand, bool);
  ///@}

protected:
  vtkResponseCurves();
  ~vtkResponseCurves() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkResponseCurves(const vtkResponseCurves&) = delete;
  void operator=(const vtkResponseCurves&) = delete;

  std::vector<vtkIdType> FindSelected(vtkPolyData* body, vtkSelection* selection);

  std::vector<vtkIdType> PointIds;
  vtkSmartPointer<vtkExtractSelection> SelectionExtractor;
  int MaximumNumberOfPoints = 20;
  int NumberOfRows = 101;
  bool ErrorBand = true;
  std::string ResponseName = "Response";
  std::vector<std::string> MoreResponseNames;
};

#endif
