// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactHistory
 * @brief the forces on a tool along its path, over time or deflection, as a table to plot
 *
 * Input: tips with their forces: the output of vtkToolContactProbe, or of vtkTrajectoryReader for a
 * trajectory that was recorded with its forces. The point arrays `Deflection` (mm) and
 * `NormalForce` (N) are required; used if present are `Time` (s), `MemoryForce` (N),
 * `FrictionForce` (3, N), the total `Force` (3, N) or `IdealForce` (N), and `SentForce` (3, N), the
 * force sent to the device.
 *
 * Output: a vtkTable, a row per tip in the order of the polyline, or of the points if there is
 * none. The first column is the Abscissa, `Time (s)` or `Deflection (mm)`; then come the other of
 * the two, if known, and `Normal Force (N)`; of a body that relaxes, `Slow Force (N)` and `Memory
 * Force (N)`, whose sum is the normal force (over deflection it makes a loop around the slow
 * force); and, if present, the magnitudes `Friction Force (N)`, `Force (N)` and `Sent Force (N)`.
 * With several polylines, each has its own rows and its own columns of forces, named `Normal Force
 * of line 2 (N)`, NaN in the rows of the others; points outside all lines are then left out.
 *
 * Errors: a required array is missing or has not one number per point (named, with the filter to
 * apply first); Abscissa is Time, but there is no `Time`.
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
   * What the forces are plotted over: the time if it is known, else the deflection (Automatic, the
   * default), Time, or Deflection.
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
