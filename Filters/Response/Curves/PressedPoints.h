// SPDX-License-Identifier: BSD-3-Clause
#ifndef PressedPoints_h
#define PressedPoints_h

#include "Response/Curves/MaterialArrays.h"

class vtkUnsignedCharArray;

namespace palpate
{
class SoundBody;

/// Index of the array to process that is not 0 at the points that get a response.
constexpr int PressedArrayIndex = 6;

/// Sets the status of the points that get no response to OutOfReach. A point that represents
/// others at its place gets a response if one of them does. Returns the number of places that get
/// no response. Without an array all points get one.
vtkIdType leaveOutOthers(
  const MaterialArray& pressed, const SoundBody& sound, vtkUnsignedCharArray* status);
} // namespace palpate

#endif
