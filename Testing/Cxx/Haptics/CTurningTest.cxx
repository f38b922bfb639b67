// SPDX-License-Identifier: BSD-3-Clause
// The C interface with a device that turns and outputs torque gives the same numbers as ServoStep.
#include "CBall.h"
#include "Haptics/Servo/ServoStep.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace palpate::testing;

namespace
{
/// The ball, with a check of the settings by the C interface.
struct Ball : CBall
{
  Ball()
    : CBall(1.0F)
  {
  }

  ContactHandle contact(const palpate_safety& safety) const
  {
    return { palpate_contact_new_safe(this->c.get(), nullptr, &safety, nullptr, 0, nullptr, 0),
      &palpate_contact_free };
  }
  /// Returns the reason for refusing a contact; "" if it is accepted.
  std::string refusal(const palpate_safety& safety) const
  {
    std::array<char, 256> reason{};
    const ContactHandle contact{ palpate_contact_new_safe(this->c.get(), nullptr, &safety, nullptr,
                                   0, reason.data(), reason.size()),
      &palpate_contact_free };
    EXPECT_EQ(contact == nullptr, reason[0] != '\0');
    return reason.data();
  }
};
} // namespace

TEST(CTurning, TorqueIsOfferedAndLimitedAsTheKernelDoes)
{
  palpate_device device;
  palpate_device_default(&device);
  EXPECT_EQ(device.maximum_torque, 0.0); // by default there is no torque
  device.maximum_torque = 0.25;
  palpate_safety safety;
  palpate_safety_of(&device, &safety);
  EXPECT_EQ(safety.maximum_torque, 0.25);
  EXPECT_EQ(
    safety.maximum_torsional_stiffness, palpate::DeviceSpecification().maximumTorsionalStiffness);
  device.maximum_torsional_stiffness = 2.0;
  palpate_safety_of(&device, &safety);
  EXPECT_EQ(safety.maximum_torsional_stiffness, 2.0);
  const Ball ball;
  EXPECT_EQ(ball.refusal(safety), "");
  safety.maximum_torque = -1.0;
  EXPECT_EQ(ball.refusal(safety), "maximum_torque must not be negative (N m), but is -1");
  safety.maximum_torque = 0.25;
  safety.maximum_torque_rate = -2.0;
  EXPECT_EQ(ball.refusal(safety), "maximum_torque_rate must be positive (N m/s), but is -2");
  safety.maximum_torque_rate = 0.0; // no limit

  // The mapping and the chain treat a turned tool in the same way as the kernel's step.
  palpate::SafetySettings settings = palpate::SafetySettings::of(palpate::DeviceSpecification());
  settings.maximumTorque = 0.25;
  settings.maximumTorsionalStiffness = 2.0;
  palpate::ServoStep servo(
    std::make_unique<palpate::ServoScene>(ball.kernel), palpate::WorkspaceMapping(), settings);
  const ContactHandle contact = ball.contact(safety);
  for (int i = 0; i < 100; ++i)
  {
    palpate_sample sample;
    palpate_sample_default(&sample);
    sample.position[2] = 0.0202 - 5e-6 * i;
    sample.orientation[0] = std::cos(0.05);
    sample.orientation[2] = std::sin(0.05);
    palpate::DeviceSample reading;
    reading.position.z() = sample.position[2];
    reading.orientation = { sample.orientation[0], 0.0, sample.orientation[2], 0.0 };
    reading.valid = true;
    palpate_full_tick tick;
    palpate_step_sample(contact.get(), &sample, 1e-3 * i, &tick);
    const palpate::Tick expected = servo.step(reading, 1e-3 * i);
    ASSERT_TRUE(expected.hasAxis());
    ASSERT_EQ(tick.acted, expected.acted);
    EXPECT_EQ(tick.tick.tilt, expected.contact.tilt);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(tick.tick.device_force[k], expected.deviceForce[k]);
      EXPECT_EQ(tick.tick.torque[k], expected.contact.torque[k]);
      EXPECT_EQ(tick.device_torque[k], expected.deviceTorque[k]);
      EXPECT_EQ(tick.ideal_torque[k], expected.idealTorque[k]);
    }
  }
}
