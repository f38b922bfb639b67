// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_MemoryWatch_h
#define palpate_endurance_MemoryWatch_h

#include <cstddef>
#include <vector>

namespace palpate::endurance
{
/**
 * The memory of this process over a run: what is resident, and what of the heap is in use (bytes
 * that were asked for and not given back, however the allocator holds them).
 *
 * It grows where the largest reading of the last quarter of the run exceeds that of the second by
 * more than is allowed; the first quarter is for caches, pools and compiled shaders.
 */
class MemoryWatch
{
public:
  /// MiB. Pages, not bytes: what fragments where bodies come and go, and what a thread touches for
  /// the first time. Measured on a busy machine: up to 0.3.
  static constexpr double ResidentAllowed = 4.0;
  /// MiB. What other threads hold for a moment (a frame that is drawn, a device on its way),
  /// measured up to 0.1. A body with its kernel is 0.2: kept at each swap, four show. In an hour,
  /// from the second quarter to the last, this is 440 bytes a swap, or a byte in nine ticks.
  static constexpr double HeapAllowed = 0.75;

  /// So many readings will come at most, so that keeping them does not count.
  explicit MemoryWatch(std::size_t readings);
  void read();

  struct Course
  {
    double first = 0.0; ///< MiB, as all
    double last = 0.0;
    double second = 0.0; ///< largest of the second quarter
    double fourth = 0.0; ///< largest of the last quarter
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
