// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * The contacts of a series of tips as point arrays: Force, NormalForce, FrictionForce, Deflection,
 * Normal, ContactPoint, ContactCell and ContactState. A body that relaxes also has MemoryForce.
 * Tools with a known axis also have Torque and Tilt. vtkToolContactProbe.h defines them.
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
  /// The values are not initialised. Therefore every tip must be stored before the arrays are
  /// attached.
  explicit ContactArrays(vtkIdType tips, bool relaxes = false, bool hasAxes = false);

  /// Stores the contact of a tip. `firstPoly` is the cell id of the body's first triangle. Several
  /// threads may store different tips at the same time.
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
  vtkSmartPointer<vtkDoubleArray> MemoryForce; ///< null if the body does not relax
  vtkSmartPointer<vtkDoubleArray> Torque;      ///< null if no tool axis is known
  vtkSmartPointer<vtkDoubleArray> Tilt;
};
} // namespace palpate

#endif
