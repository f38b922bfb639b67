// SPDX-License-Identifier: BSD-3-Clause
/**
 * The body of a proxy: whatever ParaView has, on its way to a filter that takes triangles in mm.
 *
 * A thin subclass of the filter has one of these. It says on the port that it takes any data, and
 * in RequestData runs the filter's own RequestData on replaced inputs. What is no body is an error
 * of vtkBodySurface that names the filter to use before.
 */
#ifndef palpate_BodyInput_h
#define palpate_BodyInput_h

#include "vtkBodySurface.h" // For vtkBodySurface
#include "vtkNew.h"         // For vtkNew
#include "vtkSmartPointer.h"
#include "vtkType.h" // For vtkMTimeType

#include <vector> // For std::vector

class vtkInformation;
class vtkInformationVector;

namespace palpate
{
class BodyInput
{
public:
  /// For FillInputPortInformation: any data, composites whole.
  static void admit(vtkInformation* port);

  /// For RequestUpdateExtent, after the filter's own: volumes in pieces need ghost cells.
  static void askForGhosts(vtkInformationVector** inputs, vtkInformationVector* outputs);

  /// Its settings are the user's. Not an input of the filter: count it in GetMTime.
  vtkBodySurface* surface() { return this->Surface; }

  /// The inputs of `ports` ports with the first one's data as triangles in mm; null after an error,
  /// on all ranks alike. Nothing is done again for the same data, unit and rank.
  vtkInformationVector** replace(vtkInformationVector** inputs, int ports);

private:
  bool isKept(vtkDataObject* data) const;

  vtkNew<vtkBodySurface> Surface;
  vtkSmartPointer<vtkPolyData> Kept;
  vtkMTimeType KeptFrom = 0; // MTime of the data and of the surface's settings
  vtkMTimeType KeptBy = 0;
  vtkSmartPointer<vtkInformationVector> First;
  std::vector<vtkInformationVector*> Inputs;
};
} // namespace palpate

#endif
