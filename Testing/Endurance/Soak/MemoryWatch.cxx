// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryWatch.h"

#include "ProcessMemory.h"

#include <malloc.h>

#include <algorithm>

namespace palpate::endurance
{
namespace
{
constexpr double Mebi = 1024.0 * 1024.0;

double heapBytes()
{
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}
} // namespace

MemoryWatch::MemoryWatch(std::size_t readings)
{
  this->Resident.reserve(readings);
  this->Heap.reserve(readings);
}

void MemoryWatch::read()
{
  this->Resident.push_back(testing::residentMemory() / Mebi);
  this->Heap.push_back(heapBytes() / Mebi);
}

MemoryWatch::Course MemoryWatch::course(const std::vector<double>& readings)
{
  Course course;
  if (readings.empty())
  {
    return course;
  }
  const auto quarter = static_cast<std::ptrdiff_t>(readings.size() / 4);
  const auto most = [&](std::ptrdiff_t first, std::ptrdiff_t last)
  {
    return last > first ? *std::max_element(readings.begin() + first, readings.begin() + last)
                        : 0.0;
  };
  course.first = readings.front();
  course.last = readings.back();
  course.second = most(quarter, 2 * quarter);
  course.fourth = most(3 * quarter, static_cast<std::ptrdiff_t>(readings.size()));
  return course;
}
} // namespace palpate::endurance
