// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkForceChartRepresentation
 * @brief lines in ParaView's chart, over the table's first column and with titles on the axes
 *
 * The class differs from vtkXYChartRepresentation in two ways. First, the abscissa is a column that
 * is given by its name. The default name `First column` means the first column of the table at the
 * time of drawing, so that the abscissa follows changes of the filter. Second, the axes get titles.
 * If the view leaves the titles of the bottom and left axes empty, they become the name of the
 * abscissa and `Force (N)`. Titles that the user has set in the view do not change.
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

  /** The name that means the first column of the table. */
  static const char* GetFirstColumn() { return "First column"; }

  ///@{
  /** Name of the column for the horizontal axis. Default `First column`. */
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
  std::string BottomTitle; ///< the title that this object has set
  std::string LeftTitle;
};

#endif
