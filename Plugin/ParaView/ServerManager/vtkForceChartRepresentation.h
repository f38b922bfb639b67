// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkForceChartRepresentation
 * @brief lines in ParaView's chart, over the table's first column and with titles on the axes
 *
 * As vtkXYChartRepresentation, except that the abscissa is a column by its name or, with the name
 * `First column` (the default), the column that is first when the chart is drawn, so that it
 * follows the filter; and that titles of the bottom and left axes left empty by the view become the
 * name of the abscissa and `Force (N)`. Titles set in the view are kept.
 */
#ifndef vtkForceChartRepresentation_h
#define vtkForceChartRepresentation_h

#include "palpateServerManagerModule.h" // For export macro
#include "vtkXYChartRepresentation.h"

#include <string> // For std::string

class PALPATESERVERMANAGER_EXPORT vtkForceChartRepresentation : public vtkXYChartRepresentation
{
public:
  static vtkForceChartRepresentation* New();
  vtkTypeMacro(vtkForceChartRepresentation, vtkXYChartRepresentation);

  /** The name of Abscissa for the first column. */
  static const char* GetFirstColumn() { return "First column"; }

  ///@{
  /** The column under the curves. Default `First column`. */
  void SetAbscissa(const char* name);
  const char* GetAbscissa() { return this->Abscissa.c_str(); }
  ///@}

protected:
  vtkForceChartRepresentation() = default;
  ~vtkForceChartRepresentation() override = default;
  void PrepareForRendering() override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* input, vtkInformation* output) override;

private:
  vtkForceChartRepresentation(const vtkForceChartRepresentation&) = delete;
  void operator=(const vtkForceChartRepresentation&) = delete;

  void StyleBands();
  void TitleAxis(int axis, const std::string& title, std::string& given);

  std::string Abscissa = GetFirstColumn();
  std::string BottomTitle; ///< as set by this
  std::string LeftTitle;
};

#endif
