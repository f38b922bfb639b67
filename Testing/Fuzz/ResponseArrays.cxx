// SPDX-License-Identifier: BSD-3-Clause
// Response arrays with arbitrary values on a valid body: the tick's forces are finite. Input:
// numbers of samples and laws, arrays of floats (any bits), tips.
#include "AnyTips.h"
#include "SampleBodies.h"
#include "SampleResponses.h"

#include <memory>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
float anyFloat(FuzzedDataProvider& input)
{
  const int kind = input.ConsumeIntegralInRange<int>(0, 7);
  return kind > 0 ? 0.25F * static_cast<float>(input.ConsumeIntegralInRange<int>(-4, 60))
                  : anyBits<float, std::uint32_t>(input);
}

std::vector<float> anyFloats(FuzzedDataProvider& input, std::size_t count)
{
  std::vector<float> numbers(count);
  for (float& number : numbers)
  {
    number = anyFloat(input);
  }
  return numbers;
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Surface surface = icosphere(4.0, 0);
  static const std::unique_ptr<ContactBody> sound = uniformBody(surface); // made once
  FuzzedDataProvider input(data, size);
  const std::size_t points = surface.points.size();

  ResponseArrays arrays;
  arrays.points = points;
  arrays.samples = input.ConsumeIntegralInRange<int>(2, ResponseSampling::LargestCount);
  arrays.exponent = 0.25 * input.ConsumeIntegralInRange<int>(1, 40);
  arrays.laws = input.ConsumeIntegralInRange<int>(0, 3);
  const auto samples = static_cast<std::size_t>(arrays.samples);
  const auto laws = static_cast<std::size_t>(arrays.laws);
  const std::vector<float> force = anyFloats(input, laws > 0 ? 0 : points * samples);
  const std::vector<float> stiffness = anyFloats(input, force.size());
  const std::vector<float> basis = anyFloats(input, 2 * laws * samples);
  const std::vector<float> coefficient = anyFloats(input, laws * points);
  const std::vector<float> normal = anyFloats(input, 3 * points);
  const std::vector<float> range = anyFloats(input, points);
  std::vector<std::uint8_t> status(points);
  for (std::uint8_t& one : status)
  {
    one = input.ConsumeBool() ? 0 : input.ConsumeIntegral<std::uint8_t>();
  }
  arrays.force = laws > 0 ? nullptr : force.data();
  arrays.stiffness = laws > 0 ? nullptr : stiffness.data();
  arrays.basis = laws > 0 ? basis.data() : nullptr;
  arrays.coefficient = laws > 0 ? coefficient.data() : nullptr;
  arrays.normal = normal.data();
  arrays.range = range.data();
  arrays.status = status.data();

  const ContactBody body(*sound, arrays);
  feelAround(body, surface.triangles.size(), input);
  return 0;
}
