// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_benchmarks_TimedMethod_h
#define palpate_benchmarks_TimedMethod_h

#include "CallClock.h"
#include "SampleResponses.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace palpate::benchmarks
{
/**
 * One method that finds the closest point to a tip, tick after tick. time() reads the clock
 * directly before and after the search. The virtual call and the reading of the tip are therefore
 * not measured, even with cold caches.
 */
class TimedMethod
{
public:
  virtual ~TimedMethod() = default;

  /// Finds the point for the next tip (for the next `tipsPerCall` tips). Returns the duration in
  /// counts of the CallClock.
  virtual std::uint64_t time(const Vector3* tips) = 0;
  /// Distance from the last tip to its point, mm; for several tips the sum of their distances.
  virtual double distance() const = 0;
  /// Discards the state of the last tip.
  virtual void reset() = 0;
};

/**
 * A method made of a Query. `Input prepare(tips)` runs before the clock starts, `Answer
 * operator()(const Input&)` is timed, and `distance(tips, answer)` evaluates the answer afterwards.
 * The virtual call does not load the query's own memory into the caches.
 */
template <class Query>
class Timed final : public TimedMethod
{
public:
  explicit Timed(std::unique_ptr<Query> query)
    : Ask(std::move(query))
  {
  }

  std::uint64_t time(const Vector3* tips) override
  {
    const auto input = this->Ask->prepare(tips);
    Query& query = *this->Ask;
    const std::uint64_t start = CallClock::start();
    const auto answer = query(input);
    const std::uint64_t counts = CallClock::stop() - start;
    this->Distance = query.distance(tips, answer);
    return counts;
  }
  double distance() const override { return this->Distance; }
  void reset() override { this->Ask->reset(); }

private:
  double Distance = 0.0;
  std::unique_ptr<Query> Ask;
};

template <class Query, class... Arguments>
std::unique_ptr<TimedMethod> timed(Arguments&&... arguments)
{
  return std::make_unique<Timed<Query>>(
    std::make_unique<Query>(std::forward<Arguments>(arguments)...));
}

/// Tips of one tick of palpate-tick-50-tips: a patch 10 mm wide and 5 mm long.
constexpr int PatchTips = 50;

/// Responses of the bumpy sphere: 8 samples of F = 10 δ^1.5 (N, mm) per point, with the exact
/// normals.
testing::ResponseStore bumpyResponses(const testing::Surface& surface);
std::unique_ptr<ContactBody> makePalpateBody(
  const testing::Surface& surface, const testing::ResponseStore& responses);
/// Makes the same body with responses in the compact form, with `laws` weights per point. With 1
/// law no weights are stored, because all points are equal.
std::unique_ptr<ContactBody> makeCompactBody(
  const testing::Surface& surface, const testing::ResponseStore& responses, int laws);

std::unique_ptr<TimedMethod> makePalpateTick(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpateServo(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpatePatch(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpatePoint(const ContactBody& body);
/// These methods start a new contact in each call.
std::unique_ptr<TimedMethod> makePalpateOnset(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpateOnsetTick(const ContactBody& body);

std::unique_ptr<TimedMethod> makeVtkStaticPoint(const testing::Surface& surface);
// Each returns null if the library was not found when Palpate was built.
std::unique_ptr<TimedMethod> makeCgalPoint(const testing::Surface& surface);
std::unique_ptr<TimedMethod> makeEmbreePoint(const testing::Surface& surface);
} // namespace palpate::benchmarks

#endif
