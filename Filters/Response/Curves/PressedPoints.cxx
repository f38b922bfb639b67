// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/PressedPoints.h"

#include "Contact/ResponseContract.h"
#include "Response/Bodies/SoundBody.h"

#include "vtkDataArray.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace palpate
{
vtkIdType leaveOutOthers(
  const MaterialArray& pressed, const SoundBody& sound, vtkUnsignedCharArray* status)
{
  if (!pressed.array)
  {
    return 0;
  }
  const vtkIdType points = status->GetNumberOfTuples();
  std::vector<bool> isPressed(static_cast<std::size_t>(points), false);
  for (vtkIdType i = 0; i < points; ++i)
  {
    if (pressed.array->GetTuple1(i) != 0.0)
    {
      isPressed[static_cast<std::size_t>(sound.firstAt(i))] = true;
    }
  }
  vtkIdType left = 0;
  for (vtkIdType i = 0; i < points; ++i)
  {
    if (!isPressed[static_cast<std::size_t>(i)])
    {
      left += sound.firstAt(i) == i ? 1 : 0;
      status->SetValue(i, static_cast<unsigned char>(ResponseStatus::OutOfReach));
    }
  }
  return left;
}
} // namespace palpate
