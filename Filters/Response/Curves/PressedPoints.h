// SPDX-License-Identifier: BSD-3-Clause
#ifndef PressedPoints_h
#define PressedPoints_h

#include "Response/Curves/MaterialArrays.h"

class vtkUnsignedCharArray;

namespace palpate
{
class SoundBody;

/// Index of the array to process that contains the mask of pressed points. The mask is nonzero at
/// points that get a response.
constexpr int PressedArrayIndex = 6;

/// Sets the status to OutOfReach at the points that get no response. A point may represent other
/// points at the same position. It gets a response if one of these points is in the mask. Returns
/// the number of positions that get no response. Without an array, all points get a response.
vtkIdType leaveOutOthers(
  const MaterialArray& pressed, const SoundBody& sound, vtkUnsignedCharArray* status);
} // namespace palpate

#endif
