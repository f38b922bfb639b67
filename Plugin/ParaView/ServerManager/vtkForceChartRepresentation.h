// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkForceChartRepresentation
 * @brief lines in ParaView's chart, over the table's first column and with titles on the axes
 *
 * It works as vtkXYChartRepresentation, with two exceptions. The abscissa is a column given by its
 * name. The name `First column` (default) means the first column of the table at the time of
 * drawing, so that the abscissa follows the filter. If the view leaves the titles of the bottom and
 * left axes empty, they become the name of the abscissa and `Force (N)`. Titles set in the view are
 * kept.
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

  /** Name of the Abscissa that means the first column. */
  static const char* GetFirstColumn() { return "First column"; }

  ///@{
  /** The column of the horizontal axis. Default `First column`. */
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
  std::string BottomTitle; ///< title set by this object
  std::string LeftTitle;
};

#endif
