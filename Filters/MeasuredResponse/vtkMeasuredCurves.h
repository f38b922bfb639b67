// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeasuredCurves
 * @brief measured readings and the curves of the bodies identified from them, as a table to plot
 *
 * Input: the readings of vtkMeasuredContactResponse (its output port 2), with the columns
 * `Deflection (mm)`, `Force (N)`, `ModelForce (N)`, `Site` and `Tool`.
 *
 * Output: a vtkTable with `Deflection (mm)` from first contact and two columns for every site and
 * tool, in the order of the input. `<site> measured (N)` has the readings. `<site> model (N)` has
 * the force of the identified body at the same deflection. With several tools the names are `<site>
 * measured with <tool> (N)`, and similarly for the model. The rows of a site and tool are
 * consecutive, in the order of their deflection. If the readings have a `Time (s)` because the body
 * relaxes, the rows are in the order of time, and their plotted lines are loops. The columns of a
 * site and tool are NaN in all other rows. The model of a refused site is NaN.
 *
 * Errors: a missing column is reported with its name.
 *
 * @code{.py}
 * curves = palpate.vtkMeasuredCurves()
 * curves.SetInputConnection(measured.GetOutputPort(2)) # readings of vtkMeasuredContactResponse
 * curves.Update()
 * table = curves.GetOutput()                           # Deflection (mm), N measured (N), ...
 * @endcode
 */
#ifndef vtkMeasuredCurves_h
#define vtkMeasuredCurves_h

#include "palpateMeasuredResponseModule.h" // For export macro
#include "vtkTableAlgorithm.h"

class PALPATEMEASUREDRESPONSE_EXPORT vtkMeasuredCurves : public vtkTableAlgorithm
{
public:
  static vtkMeasuredCurves* New();
  vtkTypeMacro(vtkMeasuredCurves, vtkTableAlgorithm);

protected:
  vtkMeasuredCurves() = default;
  ~vtkMeasuredCurves() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkMeasuredCurves(const vtkMeasuredCurves&) = delete;
  void operator=(const vtkMeasuredCurves&) = delete;
};

#endif
