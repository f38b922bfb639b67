// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactHistory
 * @brief the forces on a tool along its path, over time or deflection, as a table to plot
 *
 * Input: tips with their forces, from vtkToolContactProbe, or from vtkTrajectoryReader for a
 * trajectory that was recorded with its forces. The point arrays `Deflection` (mm) and
 * `NormalForce` (N) are required. These arrays are used if they are present: `Time` (s),
 * `MemoryForce` (N), `FrictionForce` (3 components, N), the total `Force` (3 components, N) or
 * `IdealForce` (N), and `SentForce` (3 components, N), which is the force sent to the device.
 *
 * Output: a vtkTable with a row per tip, in the order of the polyline. If the input has no
 * polyline, the rows are in the order of the points. The first column is the Abscissa, `Time (s)`
 * or `Deflection (mm)`. The next columns are the other of these two quantities, if known, and
 * `Normal Force (N)`. For a body that relaxes, `Slow Force (N)` and `Memory Force (N)` follow.
 * Their sum is the normal force. In a plot over deflection, the normal force forms a loop around
 * the slow force. If present, the magnitudes `Friction Force (N)`, `Force (N)` and `Sent Force (N)`
 * follow. With several polylines, each has its own rows and its own force columns, named `Normal
 * Force of line 2 (N)`. These columns are NaN in the rows of other polylines. Points outside all
 * polylines are then left out.
 *
 * Errors: a required array is missing or does not have one number per point (the error names the
 * array and the filter to apply first); Abscissa is Time, but the input has no array `Time`.
 *
 * @code{.py}
 * history = palpate.vtkContactHistory()
 * history.SetInputConnection(probe.GetOutputPort())    # tips along one polyline
 * history.SetAbscissaToDeflection()
 * history.Update()
 * table = history.GetOutput()                          # Deflection (mm), Normal Force (N), ...
 * @endcode
 */
#ifndef vtkContactHistory_h
#define vtkContactHistory_h

#include "palpateResponseModule.h" // For export macro
#include "vtkTableAlgorithm.h"

class PALPATERESPONSE_EXPORT vtkContactHistory : public vtkTableAlgorithm
{
public:
  static vtkContactHistory* New();
  vtkTypeMacro(vtkContactHistory, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Abscissa.
  enum AbscissaType
  {
    Automatic = 0,
    Time = 1,
    Deflection = 2
  };

  ///@{
  /**
   * Abscissa of the plot. Automatic (default) selects the time if it is known, else the deflection.
   * The other values are Time and Deflection.
   */
  vtkSetClampMacro(Abscissa, int, Automatic, Deflection);
  vtkGetMacro(Abscissa, int);
  void SetAbscissaToAutomatic() { this->SetAbscissa(Automatic); }
  void SetAbscissaToTime() { this->SetAbscissa(Time); }
  void SetAbscissaToDeflection() { this->SetAbscissa(Deflection); }
  ///@}

protected:
  vtkContactHistory() = default;
  ~vtkContactHistory() override = default;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkContactHistory(const vtkContactHistory&) = delete;
  void operator=(const vtkContactHistory&) = delete;

  int Abscissa = Automatic;
};

#endif
