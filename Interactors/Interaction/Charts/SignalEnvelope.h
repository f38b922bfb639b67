// SPDX-License-Identifier: BSD-3-Clause
#ifndef SignalEnvelope_h
#define SignalEnvelope_h

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace palpate
{
/**
 * Stores the last seconds of a signal in a bounded number of points, regardless of the rate of the
 * signal. Time is divided into `bins` equal intervals. Each interval keeps its smallest and its
 * largest value with their times, so that no peak is lost. A signal with at most one value per
 * interval is stored unchanged.
 *
 * A pause counts as a gap if it is longer than GapShare of the stored time and longer than three
 * times the preceding interval between values. Values that are not finite are left out. Times must
 * not decrease.
 */
class SignalEnvelope
{
public:
  static constexpr double GapShare = 0.02;

  SignalEnvelope(double seconds, std::size_t bins)
    : Seconds(seconds)
    , Width(seconds / static_cast<double>(bins))
    , Bins(bins + 1)
  {
  }

  void add(double time, double value)
  {
    if (!std::isfinite(value))
    {
      return;
    }
    const auto number = static_cast<std::int64_t>(std::floor(time / this->Width));
    Bin& bin = this->binOf(number);
    const double pause = time - this->Newest;
    if (bin.number != number)
    {
      bin = { number, { time, value }, { time, value }, false };
      bin.afterGap = pause > GapShare * this->Seconds && pause > 3.0 * this->Interval;
    }
    bin.least = value < bin.least.value ? Point{ time, value } : bin.least;
    bin.largest = value > bin.largest.value ? Point{ time, value } : bin.largest;
    this->Interval = pause;
    this->Newest = time;
  }

  void clear() { *this = SignalEnvelope(this->Seconds, this->Bins.size() - 1); }
  double seconds() const { return this->Seconds; }
  /// Time of the newest value, s. -inf if there is no value.
  double newest() const { return this->Newest; }

  /// Calls point(time, value) for the values of the last seconds before `now`, oldest first. Calls
  /// gap() at each gap.
  template <class OnPoint, class OnGap>
  void visit(double now, const OnPoint& point, const OnGap& gap) const
  {
    if (!std::isfinite(this->Newest))
    {
      return;
    }
    const auto last = static_cast<std::int64_t>(std::floor(this->Newest / this->Width));
    const auto count = static_cast<std::int64_t>(this->Bins.size());
    for (std::int64_t number = last - count + 1; number <= last; ++number)
    {
      const Bin& bin = this->binOf(number);
      if (bin.number != number)
      {
        continue;
      }
      if (bin.afterGap)
      {
        gap();
      }
      const bool falls = bin.largest.time < bin.least.time;
      const Point& first = falls ? bin.largest : bin.least;
      const Point& second = falls ? bin.least : bin.largest;
      for (const Point* each : { &first, &second })
      {
        const bool isNew = each == &first || second.time > first.time;
        if (isNew && each->time >= now - this->Seconds)
        {
          point(each->time, each->value);
        }
      }
    }
  }

private:
  struct Point
  {
    double time = 0.0;
    double value = 0.0;
  };
  struct Bin
  {
    std::int64_t number = std::numeric_limits<std::int64_t>::min();
    Point least;
    Point largest;
    bool afterGap = false;
  };

  std::size_t slotOf(std::int64_t number) const
  {
    const auto count = static_cast<std::int64_t>(this->Bins.size());
    return static_cast<std::size_t>(((number % count) + count) % count);
  }
  Bin& binOf(std::int64_t number) { return this->Bins[this->slotOf(number)]; }
  const Bin& binOf(std::int64_t number) const { return this->Bins[this->slotOf(number)]; }

  double Seconds;
  double Width; ///< width of a bin, s
  std::vector<Bin> Bins;
  double Newest = -std::numeric_limits<double>::infinity();
  /// Time between the last two values, s.
  double Interval = std::numeric_limits<double>::infinity();
};
} // namespace palpate

#endif
