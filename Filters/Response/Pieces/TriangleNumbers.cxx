// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Pieces/TriangleNumbers.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate
{
namespace
{
std::vector<double> stackNumbersOf(const LayerStack& stack)
{
  std::vector<double> numbers;
  const auto add = [&numbers](const StackLayer& layer, double thickness)
  {
    numbers.insert(numbers.end(),
      { thickness, layer.youngsModulus, layer.poissonRatio, layer.slips ? 1.0 : 0.0 });
  };
  for (const StackLayer& layer : stack.layers)
  {
    add(layer, layer.thickness);
  }
  if (stack.hasHalfSpace)
  {
    add(stack.halfSpace, 0.0);
  }
  return numbers;
}
} // namespace

LayerStack stackOf(const std::vector<double>& numbers, LayerBase base)
{
  LayerStack stack;
  stack.base = base;
  for (std::size_t i = 0; i + 3 < numbers.size(); i += 4)
  {
    const StackLayer layer{ numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3] != 0.0 };
    if (layer.thickness > 0.0)
    {
      stack.layers.push_back(layer);
    }
    else
    {
      stack.hasHalfSpace = true;
      stack.halfSpace = layer;
    }
  }
  return stack;
}

std::vector<double> triangleNumbersOf(const FieldTriangle& triangle)
{
  std::vector<double> numbers;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3& x = triangle.corners[k];
    numbers.insert(numbers.end(), { x.x(), x.y(), x.z(), triangle.thickness[k] });
  }
  numbers.push_back(static_cast<double>(triangle.base));
  numbers.insert(numbers.end(), triangle.second.begin(), triangle.second.end());
  const std::vector<double> stack = stackNumbersOf(triangle.stack);
  for (const NearField& near : triangle.near)
  {
    const auto flat = numbersOf(near);
    numbers.insert(numbers.end(), flat.begin(), flat.end());
  }
  numbers.push_back(static_cast<double>(stack.size()));
  numbers.insert(numbers.end(), stack.begin(), stack.end());
  for (const FieldTriangle::Mode& mode : triangle.modes)
  {
    numbers.push_back(mode.sign);
    for (const Vector3& phi : mode.vectors)
    {
      numbers.insert(numbers.end(), phi.data(), phi.data() + 3);
    }
  }
  return numbers;
}

FieldTriangle triangleOf(const std::vector<double>& numbers)
{
  FieldTriangle triangle;
  const double* next = numbers.data();
  for (std::size_t k = 0; k < 3; ++k, next += 4)
  {
    triangle.corners[k] = Vector3(next);
    triangle.thickness[k] = next[3];
  }
  triangle.base = static_cast<LayerBase>(static_cast<int>(*next++));
  std::copy_n(next, 3, triangle.second.begin());
  next += 3;
  for (NearField& near : triangle.near)
  {
    std::array<double, NearField::Numbers> flat{};
    std::copy_n(next, flat.size(), flat.begin());
    near = nearFieldOf(flat);
    next += flat.size();
  }
  const auto stackNumbers = static_cast<std::ptrdiff_t>(*next++);
  triangle.stack = stackOf({ next, next + stackNumbers }, triangle.base);
  next += stackNumbers;
  while (next < numbers.data() + numbers.size())
  {
    triangle.modes.push_back(
      { next[0], { Vector3(next + 1), Vector3(next + 4), Vector3(next + 7) } });
    next += 10;
  }
  return triangle;
}
} // namespace palpate
