// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Curves/PressedPoints.h"

#include "Contact/ResponseContract.h"
#include "Mechanics/JoinedText.h"
#include "Response/Bodies/SoundBody.h"

#include "vtkDataArray.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace palpate
{
std::string checkPressed(const MaterialArray& pressed, vtkIdType points)
{
  const auto& [name, array] = pressed;
  if (name.empty())
  {
    return {};
  }
  if (!array)
  {
    return joined(
      "Array to process ", PressedArrayIndex, " ('", name, "') is not on the input's points");
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != points)
  {
    return joined("Array '", name, "' must have 1 component and ", points, " tuples, but has ",
      array->GetNumberOfComponents(), " and ", array->GetNumberOfTuples());
  }
  return {};
}

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
