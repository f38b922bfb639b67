// SPDX-License-Identifier: BSD-3-Clause
// Palpate's own methods of the benchmark. Only this file of the benchmark uses the kernel's
// classes.
#include "BumpySphere.h"
#include "Contact/ContactBody.h"
#include "Haptics/Safety/SafetyLinks.h"
#include "Haptics/Servo/ServoStep.h"
#include "TimedMethod.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace palpate::benchmarks
{
namespace
{
/// N; less than the 10 N of a tip 1 mm deep, so that the limit acts in every tick.
constexpr double MaximumForce = 8.0;

/// Default friction, elasto-plastic. The contact slides after the first tenths of a millimetre.
ContactSettings withFriction()
{
  ContactSettings settings;
  settings.friction.coefficient = 0.5;
  return settings;
}

/// Returns the depth of a tick, mm; NaN if its contact is not as expected.
double depthFelt(const Contact& contact, const Vector3& sent)
{
  const bool slides = contact.state == ContactState::Slide && contact.friction.norm() > 0.0;
  const bool inContact = contact.state == ContactState::Stick || slides;
  const bool limited = std::abs(sent.norm() - MaximumForce) < 1e-9 * MaximumForce;
  return inContact && limited ? contact.deflection : std::nan("");
}

/// A tick from the tip to the limited force. The contact continues from call to call; with Onset,
/// each call starts a new contact.
template <bool Onset>
class PalpateTick
{
public:
  explicit PalpateTick(const ContactBody& body)
    : Touch(body, withFriction())
  {
  }
  struct Answer
  {
    Contact contact;
    Vector3 sent;
  };
  Vector3 prepare(const Vector3* tips)
  {
    if (Onset)
    {
      this->Touch.reset();
    }
    return *tips;
  }
  Answer operator()(const Vector3& tip)
  {
    Answer answer{ this->Touch.update(tip), {} };
    answer.sent = this->Limit.limit(answer.contact.force);
    return answer;
  }
  /// Also includes foresee(), which a loop calls after the force is sent.
  double distance(const Vector3* /*tips*/, const Answer& answer) const
  {
    this->Touch.foresee();
    return depthFelt(answer.contact, answer.sent);
  }
  void reset() { this->Touch.reset(); }

private:
  ToolContact Touch;
  ForceLimit Limit{ MaximumForce };
};

/// A tick from the device sample to the force for the device, with the whole safety chain. The
/// device allows the same maximum force.
class PalpateServo
{
public:
  explicit PalpateServo(const ContactBody& body)
    : Servo(sceneOn(body), WorkspaceMapping(), safety())
  {
  }
  struct Sample
  {
    DeviceSample device;
    double time;
  };
  Sample prepare(const Vector3* tips)
  {
    Sample sample;
    sample.device.position = 0.001 * *tips;
    sample.device.valid = true;
    sample.time = this->Time += 1e-3;
    return sample;
  }
  Tick operator()(const Sample& sample) { return this->Servo.step(sample.device, sample.time); }
  /// Also includes foresee(), which a loop calls after the force is sent.
  double distance(const Vector3* /*tips*/, const Tick& tick) const
  {
    this->Servo.foresee();
    // The passivity control of the chain may reduce the force.
    const double force = tick.deviceForce.norm();
    const bool isSent = force > 0.0 && force < (1.0 + 1e-9) * MaximumForce;
    return isSent ? tick.contact.deflection : std::nan("");
  }
  void reset() { this->Servo.reset(); }

private:
  static std::unique_ptr<ServoScene> sceneOn(const ContactBody& body)
  {
    const std::shared_ptr<void> nobody; // no owner, because the body outlives its methods
    return std::make_unique<ServoScene>(
      std::shared_ptr<const ContactBody>(nobody, &body), withFriction());
  }
  /// All links act except gate and slew limit, which would suppress the first force of a path.
  static SafetySettings safety()
  {
    SafetySettings settings;
    settings.maximumForce = MaximumForce;
    settings.maximumStiffness = 1e5;
    settings.gate = false;
    return settings;
  }

  ServoStep Servo;
  double Time = 0.0;
};

/// One contact per tip, all on one body.
class PalpatePatch
{
public:
  explicit PalpatePatch(const ContactBody& body)
    : Contacts(PatchTips, PalpateTick<false>(body))
  {
  }
  using Input = std::array<Vector3, PatchTips>;
  /// `force` is the result of a tick. The data of each tip are stored for the check.
  struct Answer
  {
    Vector3 force = Vector3::Zero();
    std::array<PalpateTick<false>::Answer, PatchTips> ticks;
  };
  Input prepare(const Vector3* tips)
  {
    Input patch;
    std::copy_n(tips, PatchTips, patch.begin());
    return patch;
  }
  Answer operator()(const Input& patch)
  {
    Answer answer;
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      answer.ticks[i] = this->Contacts[i](patch[i]);
      answer.force += answer.ticks[i].sent;
    }
    return answer;
  }
  double distance(const Vector3* tips, const Answer& answer) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < answer.ticks.size(); ++i)
    {
      sum += this->Contacts[i].distance(tips + i, answer.ticks[i]);
    }
    return sum;
  }
  void reset()
  {
    for (PalpateTick<false>& contact : this->Contacts)
    {
      contact.reset();
    }
  }

private:
  std::vector<PalpateTick<false>> Contacts;
};

/// Only the search of the contact point. The search follows the previous contact; with Onset, each
/// call starts a new search.
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
  ContactTracker::Result operator()(const Vector3& tip) { return this->Tracker.update(tip); }
  double distance(const Vector3* /*tips*/, const ContactTracker::Result& contact) const
  {
    return contact.outcome == ContactTracker::Outcome::Inside ? -contact.place.signedDistance
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

std::unique_ptr<ContactBody> makeCompactBody(
  const testing::Surface& surface, const testing::ResponseStore& responses, int laws)
{
  // The law of all points is split into several equal laws. If there are several, their weights
  // differ from point to point.
  ResponseArrays arrays = responses.arrays();
  const auto columns = static_cast<std::size_t>(arrays.samples);
  const auto count = static_cast<std::size_t>(laws);
  std::vector<float> basis;
  std::vector<float> coefficients(count * arrays.points, 1.0F);
  for (std::size_t k = 0; k < count; ++k)
  {
    basis.insert(basis.end(), arrays.force, arrays.force + columns);
    basis.insert(basis.end(), arrays.stiffness, arrays.stiffness + columns);
  }
  for (float& number : basis)
  {
    number /= static_cast<float>(count);
  }
  for (std::size_t i = 0; count > 1 && i < coefficients.size(); ++i)
  {
    coefficients[i] += 0.001F * static_cast<float>(i % 7);
  }
  arrays.force = nullptr;
  arrays.stiffness = nullptr;
  arrays.laws = laws;
  arrays.basis = basis.data();
  arrays.coefficient = coefficients.data();
  return std::make_unique<ContactBody>(surface.points.front().data(), surface.points.size(),
    surface.triangles.front().data(), surface.triangles.size(), arrays);
}

std::unique_ptr<TimedMethod> makePalpateTick(const ContactBody& body)
{
  return timed<PalpateTick<false>>(body);
}
std::unique_ptr<TimedMethod> makePalpateServo(const ContactBody& body)
{
  return timed<PalpateServo>(body);
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
std::unique_ptr<TimedMethod> makePalpateOnsetTick(const ContactBody& body)
{
  return timed<PalpateTick<true>>(body);
}
} // namespace palpate::benchmarks
