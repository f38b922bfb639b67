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
 * One way of answering "what is closest to this tip?", tick after tick. time() reads the clock
 * around nothing but the call itself, so that the virtual call and the reading of the tip are
 * outside, with cold caches too.
 */
class TimedMethod
{
public:
  virtual ~TimedMethod() = default;

  /// Answers for the next tip (the next `tipsPerCall` tips); counts of the CallClock it took.
  virtual std::uint64_t time(const Vector3* tips) = 0;
  /// Distance from the last tip to the point found for it, mm; of several tips the sum.
  virtual double distance() const = 0;
  /// Forgets where the last tip was.
  virtual void reset() = 0;
};

/**
 * A method made of a Query: what is prepared before the clock starts (`Input prepare(tips)`), what
 * is timed (`Answer operator()(const Input&)`), and what is made of the answer afterwards
 * (`distance(tips, answer)`). The query's own memory is not warmed by the call.
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

/// Of the bumpy sphere: 8 samples of F = 10 δ^1.5 (N, mm) per point, with the true normals.
testing::ResponseStore bumpyResponses(const testing::Surface& surface);
std::unique_ptr<ContactBody> makePalpateBody(
  const testing::Surface& surface, const testing::ResponseStore& responses);
/// The same in the compact form: that many numbers per point; with 1, none, since all are the same.
std::unique_ptr<ContactBody> makeCompactBody(
  const testing::Surface& surface, const testing::ResponseStore& responses, int laws);

std::unique_ptr<TimedMethod> makePalpateTick(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpateServo(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpatePatch(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpatePoint(const ContactBody& body);
/// The contact is forgotten before each call.
std::unique_ptr<TimedMethod> makePalpateOnset(const ContactBody& body);
std::unique_ptr<TimedMethod> makePalpateOnsetTick(const ContactBody& body);

std::unique_ptr<TimedMethod> makeVtkStaticPoint(const testing::Surface& surface);
// Null where the library was not found when Palpate was built.
std::unique_ptr<TimedMethod> makeCgalPoint(const testing::Surface& surface);
std::unique_ptr<TimedMethod> makeEmbreePoint(const testing::Surface& surface);
} // namespace palpate::benchmarks

#endif
