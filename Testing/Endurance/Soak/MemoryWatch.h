// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_MemoryWatch_h
#define palpate_endurance_MemoryWatch_h

#include <cstddef>
#include <vector>

namespace palpate::endurance
{
/**
 * The memory of this process during a run: the resident memory, and the heap in use (bytes
 * allocated and not yet freed, without memory that the allocator keeps).
 * Memory counts as growing if the largest reading of the last quarter of the run exceeds the
 * largest reading of the second quarter by more than the allowance. The first quarter is excluded
 * because of caches, pools and compiled shaders.
 */
class MemoryWatch
{
public:
  /// Allowed growth of the resident memory, MiB. Resident memory is counted in pages. It therefore
  /// includes fragmentation by bodies that are made and freed, and pages that a thread uses for the
  /// first time. Measured on a busy machine: up to 0.3 MiB.
  static constexpr double ResidentAllowed = 4.0;
  /// Allowed growth of the heap, MiB. The software renderer occasionally takes a block of 1 MiB
  /// (measured by the call stacks of all blocks: two in an hour). Other threads temporarily hold up
  /// to 0.1 MiB (a frame that is drawn, a device that is handed over; measured). A body with its
  /// kernel takes 0.2 MiB. If one body is not freed at each swap, thirteen swaps exceed the
  /// allowance. In a run of an hour, from the second quarter to the last, the allowance is 1.5 kB
  /// per swap.
  static constexpr double HeapAllowed = 2.5;

  /// `readings` is the largest number of readings. Their memory is reserved here, so that it is not
  /// counted as growth.
  explicit MemoryWatch(std::size_t readings);
  void read();

  struct Course
  {
    double first = 0.0; ///< MiB, like the other members
    double last = 0.0;
    double second = 0.0; ///< largest reading of the second quarter
    double fourth = 0.0; ///< largest reading of the last quarter
    double growth() const { return this->fourth - this->second; }
  };
  Course resident() const { return course(this->Resident); }
  Course heap() const { return course(this->Heap); }

private:
  static Course course(const std::vector<double>& readings);

  std::vector<double> Resident;
  std::vector<double> Heap;
};
} // namespace palpate::endurance

#endif
