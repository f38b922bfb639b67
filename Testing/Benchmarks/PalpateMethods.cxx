// SPDX-License-Identifier: BSD-3-Clause
// Palpate's own rows of the benchmark: the only file of it that knows the kernel's classes.
#include "BumpySphere.h"
#include "ContactBody.h"
#include "ServoStep.h"
#include "TimedMethod.h"

#include <array>
#include <cmath>
#include <vector>

namespace palpate::benchmarks
{
namespace
{
/// Below the 10 N of a tip 1 mm deep, so that the limit is at work in every tick.
constexpr double MaximumForce = 8.0;

DeviceSample sampleAt(const Vector3& tip)
{
  DeviceSample sample;
  sample.position = 0.001 * tip;
  sample.valid = true;
  return sample;
}

/// Friction as it is by default, elasto-plastic: after the first tenths of a millimetre it slides.
ServoStep makeServo(const ContactBody& body)
{
  ContactSettings settings;
  settings.friction.coefficient = 0.5;
  return ServoStep(body, WorkspaceMapping(), MaximumForce, settings);
}

/// Depth of a tick; NaN if it did not feel what it should.
double depthFelt(const ServoTick& tick)
{
  const ContactState state = tick.contact.state;
  const bool slides = state == ContactState::Slide && tick.contact.friction.norm() > 0.0;
  const bool inContact = state == ContactState::Stick || slides;
  const double force = tick.deviceForce.norm();
  const bool limited = std::abs(force - MaximumForce) < 1e-9 * MaximumForce;
  return inContact && limited ? tick.contact.deflection : std::nan("");
}

/// Device sample in, force for the device out.
class PalpateTick
{
public:
  explicit PalpateTick(const ContactBody& body)
    : Servo(makeServo(body))
  {
  }
  DeviceSample prepare(const Vector3* tips) { return sampleAt(*tips); }
  ServoTick operator()(const DeviceSample& sample) { return this->Servo.step(sample, 0.0); }
  double distance(const Vector3* /*tips*/, const ServoTick& tick) const { return depthFelt(tick); }
  void reset() { this->Servo.reset(); }

private:
  ServoStep Servo;
};

/// As many histories on one body.
class PalpatePatch
{
public:
  explicit PalpatePatch(const ContactBody& body)
    : Servos(PatchTips, makeServo(body))
  {
  }
  using Input = std::array<DeviceSample, PatchTips>;
  /// Its force is what a tick is for; the rest of each tip is kept for the check.
  struct Answer
  {
    Vector3 force = Vector3::Zero();
    std::array<ServoTick, PatchTips> ticks;
  };
  Input prepare(const Vector3* tips)
  {
    Input samples;
    for (DeviceSample& sample : samples)
    {
      sample = sampleAt(*tips++);
    }
    return samples;
  }
  Answer operator()(const Input& samples)
  {
    Answer answer;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      answer.ticks[i] = this->Servos[i].step(samples[i], 0.0);
      answer.force += answer.ticks[i].deviceForce;
    }
    return answer;
  }
  double distance(const Vector3* /*tips*/, const Answer& answer) const
  {
    double sum = 0.0;
    for (const ServoTick& tick : answer.ticks)
    {
      sum += depthFelt(tick);
    }
    return sum;
  }
  void reset()
  {
    for (ServoStep& servo : this->Servos)
    {
      servo.reset();
    }
  }

private:
  std::vector<ServoStep> Servos;
};

/// The contact point alone, followed or found anew.
template <bool Onset>
class PalpatePoint
{
public:
  explicit PalpatePoint(const ContactBody& body)
    : Tracker(body.surface, body.tree)
  {
  }
  Vector3 prepare(const Vector3* tips)
  {
    if (Onset)
    {
      this->Tracker.reset();
    }
    return *tips;
  }
  ContactTracker::Contact operator()(const Vector3& tip) { return this->Tracker.update(tip); }
  double distance(const Vector3* /*tips*/, const ContactTracker::Contact& contact) const
  {
    return contact.outcome == ContactTracker::Outcome::Inside ? -contact.surface.signedDistance
                                                              : std::nan("");
  }
  void reset() { this->Tracker.reset(); }

private:
  ContactTracker Tracker;
};
} // namespace

testing::ResponseStore bumpyResponses(const testing::Surface& surface)
{
  testing::ResponseStore responses(surface.points.size());
  const std::vector<Vector3> normals = testing::bumpyNormals(surface);
  for (std::size_t p = 0; p < normals.size(); ++p)
  {
    Eigen::Map<Eigen::Vector3f>(responses.normal.data() + 3 * p) = normals[p].cast<float>();
  }
  return responses;
}

std::unique_ptr<ContactBody> makePalpateBody(
  const testing::Surface& surface, const testing::ResponseStore& responses)
{
  return std::make_unique<ContactBody>(surface.points.front().data(), surface.points.size(),
    surface.triangles.front().data(), surface.triangles.size(), responses.arrays());
}

std::unique_ptr<TimedMethod> makePalpateTick(const ContactBody& body)
{
  return timed<PalpateTick>(body);
}
std::unique_ptr<TimedMethod> makePalpatePatch(const ContactBody& body)
{
  return timed<PalpatePatch>(body);
}
std::unique_ptr<TimedMethod> makePalpatePoint(const ContactBody& body)
{
  return timed<PalpatePoint<false>>(body);
}
std::unique_ptr<TimedMethod> makePalpateOnset(const ContactBody& body)
{
  return timed<PalpatePoint<true>>(body);
}
} // namespace palpate::benchmarks
