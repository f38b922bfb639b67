// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkResponseChart
 * @brief force over deflection, one curve per tool or point, in a vtkChartXY
 *
 * Add curves as vtkTables, each with a label. The first column is the deflection (mm) and the
 * second is the force (N), as in the tables of vtkResponseCurves. The chart has axis titles with
 * units, a legend, and colours and dashes that colour-blind readers can distinguish. It starts at
 * (0, 0) and ends with the longest curve.
 *
 * A curve may have a depth of validity; beyond this depth the line is dotted. A third and a fourth
 * column of a table are the bounds of the force (N); a band is drawn between them.
 *
 * @code{.py}
 * chart = palpate.vtkResponseChart()
 * chart.SetTitle("A ball under two tools")
 * chart.AddCurve(curves.GetOutput(), "sphere:6.35")    # vtkResponseCurves: mm, N
 * view.GetScene().AddItem(chart.GetChart())            # a vtkContextView
 * @endcode
 */
#ifndef vtkResponseChart_h
#define vtkResponseChart_h

#include "palpateInteractionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkChartXY;
class vtkTable;

class PALPATEINTERACTION_EXPORT vtkResponseChart : public vtkObject
{
public:
  static vtkResponseChart* New();
  vtkTypeMacro(vtkResponseChart, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The chart, to be added to a context scene (vtkContextView). */
  vtkChartXY* GetChart();

  void SetTitle(const std::string& title);

  /**
   * Adds a curve. It is solid up to `validDepth` (mm) and dotted beyond that depth. Returns false
   * and reports an error if the table has fewer than two columns.
   */
  bool AddCurve(vtkTable* table, const std::string& label, double validDepth);
  bool AddCurve(vtkTable* table, const std::string& label);

  void RemoveAllCurves();

protected:
  vtkResponseChart();
  ~vtkResponseChart() override;

private:
  vtkResponseChart(const vtkResponseChart&) = delete;
  void operator=(const vtkResponseChart&) = delete;

  void AddBand(vtkTable* table);
  void AddLine(vtkTable* table, const std::string& label, int penStyle);

  vtkSmartPointer<vtkChartXY> Chart;
  int Curves = 0;
  bool HasBand = false; ///< whether the legend already explains a band
  double LargestDeflection = 0.0;
  double LargestForce = 0.0;
};

#endif
