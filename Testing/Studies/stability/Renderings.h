// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_Renderings_h
#define palpate_testing_Renderings_h

#include "Haptics/Servo/ServoStep.h"
#include "VirtualLoop.h"

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace palpate::testing
{
/// A law evaluated at run time on the plane z = 0, without checks, limits or memory of earlier
/// readings: a loop of ten lines.
class BareLaw final : public Rendering
{
public:
  /// `law`: from depth in mm to force in N.
  explicit BareLaw(std::function<double(double)> law)
    : Law(std::move(law))
  {
  }
  Eigen::Vector3d force(const DeviceSample& sample, double /*time*/) noexcept override
  {
    const double depth = -1e3 * sample.position.z();
    this->Free = depth <= 0.0;
    return { 0.0, 0.0, depth <= 0.0 ? 0.0 : this->Law(depth) };
  }

  bool isFree() const noexcept override { return this->Free; }

private:
  std::function<double(double)> Law;
  bool Free = true;
};

/// A body with a stored response, evaluated by a ServoStep.
class ServoRendering final : public Rendering
{
public:
  ServoRendering(const std::shared_ptr<const ContactBody>& body, const SafetySettings& safety,
    const ContactSettings& contact = {})
    : Step(std::make_unique<ServoScene>(body, contact), WorkspaceMapping(), safety)
  {
  }
  Eigen::Vector3d force(const DeviceSample& sample, double time) noexcept override
  {
    this->Last = this->Step.step(sample, time);
    return this->Last.deviceForce;
  }
  double holdTime() const noexcept override
  {
    return std::isfinite(this->Last.holdTime) ? this->Last.holdTime : Rendering::holdTime();
  }
  bool isFree() const noexcept override { return this->Last.contact.state == ContactState::None; }

private:
  ServoStep Step;
  Tick Last;
};

/// Links of the safety chain that are on.
enum class Control
{
  None,         ///< only the force limit, which is infinite unless it is set
  Cap,          ///< stiffness cap, at 2b/T
  Passivity,    ///< passivity control, at 2b/T
  ChainAtLimit, ///< all links, for 2b/T, with a device that states no delay
  Chain         ///< all links, as the device states: for b/T, with the bound of its delay
};
constexpr Control AllControls[] = { Control::None, Control::Cap, Control::Passivity,
  Control::ChainAtLimit, Control::Chain };
const char* nameOf(Control control);
/// Settings for the device of the setting (LoopSetting::specification).
SafetySettings safetyOf(Control control, const LoopSetting& setting);
} // namespace palpate::testing

#endif
