// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkContactHistory
 * @brief what a tool felt along its way, over time or deflection, as a table to plot
 *
 * Input: tips with what they feel: the output of vtkToolContactProbe, or of vtkTrajectoryReader for
 * a trajectory that was recorded with its forces. Required are the point arrays `Deflection` (mm)
 * and `NormalForce` (N); used if they are there are `Time` (s), `MemoryForce` (N), `FrictionForce`
 * (3, N), the total `Force` (3, N) or `IdealForce` (N), and `SentForce` (3, N), what the device was
 * told.
 *
 * Output: a vtkTable, a row per tip in the order of the polyline, of the points if there is none.
 * The first column is the Abscissa, `Time (s)` or `Deflection (mm)`; then come the other of the two
 * if it is known, and `Normal Force (N)`; as far as they are there, of a body that relaxes `Slow
 * Force (N)` and `Memory Force (N)`, whose sum is the normal force: over deflection the normal
 * force makes a loop around the slow one; and `Friction Force (N)`, `Force (N)` and `Sent Force
 * (N)`, magnitudes. With several polylines, each has its own rows and its own columns of forces,
 * named `Normal Force of line 2 (N)`, NaN in the rows of the others; points of no line are then
 * left out.
 *
 * Errors: a required array is missing or not a number per point (named, with what to apply first);
 * Abscissa is Time, but no `Time` is known.
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
  /** What the forces are plotted over: the time where it is known and the deflection otherwise
   * (Automatic, the default), Time, or Deflection. */
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
