// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The contact of each of a row of tips as point arrays: Force, NormalForce, FrictionForce,
 * Deflection, Normal, ContactPoint, ContactCell, ContactState, and of a body that relaxes
 * MemoryForce, of tools whose axis is known Torque and Tilt. Their meaning: see
 * vtkToolContactProbe.h.
 */
#ifndef ContactArrays_h
#define ContactArrays_h

#include "palpateResponseModule.h" // For export macro

#include "Contact/ToolContact.h" // For palpate::Contact

#include "vtkDoubleArray.h"       // For vtkDoubleArray
#include "vtkIdTypeArray.h"       // For vtkIdTypeArray
#include "vtkNew.h"               // For vtkNew
#include "vtkSmartPointer.h"      // For vtkSmartPointer
#include "vtkUnsignedCharArray.h" // For vtkUnsignedCharArray

class vtkPolyData;

namespace palpate
{
/// The arrays of probed or recorded tips: Force, FrictionForce, Deflection, ContactState and so on.
class PALPATERESPONSE_EXPORT ContactArrays
{
public:
  /// Every tip must be stored before they are attached: the values are not set.
  explicit ContactArrays(vtkIdType tips, bool relaxes = false, bool hasAxes = false);

  /// `firstPoly` is the cell id of the body's first triangle. May run for different tips at once.
  void store(vtkIdType tip, const Contact& contact, vtkIdType firstPoly);

  void attach(vtkPolyData* tips);

private:
  vtkNew<vtkDoubleArray> Force;
  vtkNew<vtkDoubleArray> NormalForce;
  vtkNew<vtkDoubleArray> FrictionForce;
  vtkNew<vtkDoubleArray> Deflection;
  vtkNew<vtkDoubleArray> Normal;
  vtkNew<vtkDoubleArray> ContactPoint;
  vtkNew<vtkIdTypeArray> ContactCell;
  vtkNew<vtkUnsignedCharArray> ContactState;
  vtkSmartPointer<vtkDoubleArray> MemoryForce; ///< null: nothing relaxes
  vtkSmartPointer<vtkDoubleArray> Torque;      ///< null: no axis is known
  vtkSmartPointer<vtkDoubleArray> Tilt;
};
} // namespace palpate

#endif
