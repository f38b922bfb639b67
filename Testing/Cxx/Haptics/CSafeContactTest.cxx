// SPDX-License-Identifier: BSD-3-Clause
// The part of the C interface with mapping, safety, clutch and scenes gives the same numbers as
// ServoStep.
#include "CBall.h"
#include "Haptics/Servo/ServoStep.h"
#include "Mechanics/Numerics/Constants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace c_safe_contact
{
using namespace palpate::testing;
using Eigen::Vector3d;
using palpate::Infinity;
using palpate::NotANumber;

namespace
{
palpate_safety usualSafety()
{
  palpate_safety safety;
  palpate_safety_of(nullptr, &safety);
  return safety;
}

ContactHandle makeContact(const palpate_body* body, const palpate_mapping* mapping,
  const palpate_safety& safety, unsigned int clutch = 0)
{
  return { palpate_contact_new_safe(body, mapping, &safety, nullptr, clutch, nullptr, 0),
    &palpate_contact_free };
}

/// Returns the reason for refusing a contact; "" if it is accepted.
std::string refusal(
  const palpate_body* body, const palpate_mapping* mapping, const palpate_safety* safety)
{
  std::array<char, 256> reason{};
  const ContactHandle contact{ palpate_contact_new_safe(
                                 body, mapping, safety, nullptr, 0, reason.data(), reason.size()),
    &palpate_contact_free };
  EXPECT_EQ(contact == nullptr, reason[0] != '\0');
  return reason.data();
}

void expectSame(const palpate_full_tick& c, const palpate::Tick& expected)
{
  ASSERT_EQ(c.tick.state, static_cast<int>(expected.contact.state));
  EXPECT_EQ(c.tick.normal_force, expected.contact.normalForce);
  EXPECT_EQ(c.tick.triangle, expected.contact.triangle);
  EXPECT_EQ(c.force_factor, expected.forceFactor);
  EXPECT_EQ(c.scene_share, expected.sceneShare);
  EXPECT_EQ(c.scene, expected.scene);
  EXPECT_EQ(c.acted, expected.acted);
  EXPECT_EQ(c.valid != 0, expected.valid);
  EXPECT_EQ(c.clutched != 0, expected.clutched);
  for (int k = 0; k < 3; ++k)
  {
    ASSERT_EQ(c.tick.device_force[k], expected.deviceForce[k]);
    EXPECT_EQ(c.tick.tip[k], expected.tip[k]);
    EXPECT_EQ(c.tick.force[k], expected.contact.force[k]);
    EXPECT_EQ(c.velocity[k], expected.velocity[k]);
    EXPECT_EQ(c.ideal_force[k], expected.idealForce[k]);
    EXPECT_EQ(c.applied_force[k], expected.appliedForce[k]);
  }
}
} // namespace

TEST(CSafeContact, StepsAsServoStepDoesThroughAllThereIs)
{
  const CBall soft(1.0F);
  const CBall hard(6.0F);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  palpate_mapping place;
  palpate_mapping_default(&place);
  for (int i = 0; i < 9; ++i)
  {
    place.rotation[i] = turn(i / 3, i % 3); // row by row
  }
  place.translation[1] = 4.0;
  place.scale = 2.0;
  const palpate::WorkspaceMapping mapping(turn, Vector3d(0, 4, 0), 2.0);

  palpate_device device;
  palpate_device_default(&device);
  device.maximum_force = 6.0;
  device.maximum_stiffness = 15e3;
  device.maximum_force_rate = 2e3;
  device.rate = 2000.0;
  device.sample_time_out = 0.005;
  palpate_safety safety;
  palpate_safety_of(&device, &safety);
  safety.force_factor = 0.5;
  safety.entry_ramp = 0.1;
  palpate::DeviceSpecification specification;
  specification.maximumForce = 6.0;
  specification.maximumStiffness = 15e3;
  specification.maximumForceRate = 2e3;
  specification.rate = 2000.0;
  specification.sampleTimeOut = 0.005;
  palpate::SafetySettings same = palpate::SafetySettings::of(specification);
  same.forceFactor = 0.5;
  same.entryRamp = 0.1;

  const ContactHandle contact = makeContact(soft.c.get(), &place, safety, 2);
  ASSERT_NE(contact, nullptr);
  palpate::ServoStep servo(std::make_unique<palpate::ServoScene>(soft.kernel), mapping, same, 2);
  palpate_settings rough;
  palpate_settings_default(&rough);
  rough.friction_coefficient = 0.4;
  palpate::ContactSettings sameRough;
  sameRough.friction.coefficient = 0.4;

  unsigned int acted = 0;
  int blended = 0;
  int clutched = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const double t = 5e-4 * i;
    if (i == 1500)
    {
      std::array<char, 256> reason{};
      palpate_scene* scene =
        palpate_scene_new(hard.c.get(), &rough, 0.3, reason.data(), reason.size());
      ASSERT_NE(scene, nullptr) << reason.data();
      palpate_change(contact.get(), scene);
      servo.change(std::make_unique<palpate::ServoScene>(hard.kernel, sameRough, 0.3));
    }
    if (i == 5500)
    {
      palpate_stop(contact.get());
      servo.stop();
    }
    const Vector3d tip = (20.0 - 1.2 * std::sin(8.0 * t)) *
      Vector3d(std::cos(t), std::sin(t) * std::cos(3.0 * t), std::sin(t) * std::sin(3.0 * t));
    palpate::DeviceSample sample;
    sample.position = mapping.toDevice(tip);
    sample.velocity = Vector3d(0.1 * t, -0.2, 0.3);
    sample.buttons = i > 3000 && i < 3400 ? 3 : 1;
    sample.valid = i % 1999 != 1998;
    sample.fresh = i < 4500 || i > 4520;
    palpate_sample reading;
    palpate_sample_default(&reading);
    std::copy_n(sample.position.data(), 3, reading.position);
    std::copy_n(sample.velocity.data(), 3, reading.velocity);
    reading.buttons = sample.buttons;
    reading.valid = sample.valid;
    reading.fresh = sample.fresh;
    palpate_full_tick tick;
    palpate_step_sample(contact.get(), &reading, t, &tick);
    ASSERT_NO_FATAL_FAILURE(expectSame(tick, servo.step(sample, t))) << i;
    acted |= tick.acted;
    blended += tick.scene_share > 0.0 && tick.scene_share < 1.0;
    clutched += tick.clutched;
  }
  EXPECT_GE(blended, 98); // the ramp takes 50 ms at 2 kHz
  EXPECT_EQ(clutched, 399);
  for (const int link : { PALPATE_GATE, PALPATE_FIT, PALPATE_STIFFNESS_CAP, PALPATE_MAGNITUDE,
         PALPATE_WATCHDOG, PALPATE_NO_SAMPLE, PALPATE_STOPPED })
  {
    EXPECT_NE(acted & static_cast<unsigned int>(link), 0U) << link;
  }
  palpate_start(contact.get());
  const SceneHandle retired{ palpate_take_retired(contact.get()), &palpate_scene_free };
  EXPECT_NE(retired, nullptr);
  EXPECT_EQ(palpate_take_retired(contact.get()), nullptr);
}

TEST(CSafeContact, TheLinksHaveTheKernelsNumbers)
{
  using palpate::SafetyLink;
  EXPECT_EQ(PALPATE_NOT_FINITE, static_cast<int>(SafetyLink::NotFinite));
  EXPECT_EQ(PALPATE_GATE, static_cast<int>(SafetyLink::Gate));
  EXPECT_EQ(PALPATE_FIT, static_cast<int>(SafetyLink::Fit));
  EXPECT_EQ(PALPATE_STIFFNESS_CAP, static_cast<int>(SafetyLink::StiffnessCap));
  EXPECT_EQ(PALPATE_SLEW, static_cast<int>(SafetyLink::Slew));
  EXPECT_EQ(PALPATE_MAGNITUDE, static_cast<int>(SafetyLink::Magnitude));
  EXPECT_EQ(PALPATE_PASSIVITY, static_cast<int>(SafetyLink::Passivity));
  EXPECT_EQ(PALPATE_WATCHDOG, static_cast<int>(SafetyLink::Watchdog));
  EXPECT_EQ(PALPATE_NO_SAMPLE, static_cast<int>(SafetyLink::NoSample));
  EXPECT_EQ(PALPATE_STOPPED, static_cast<int>(SafetyLink::Stopped));
}

TEST(CSafeContact, DefaultsAreThoseOfTheKernel)
{
  const palpate_safety safety = usualSafety();
  const auto usual = palpate::SafetySettings::of(palpate::DeviceSpecification());
  EXPECT_EQ(safety.gate != 0, usual.gate);
  EXPECT_EQ(safety.entry_ramp, usual.entryRamp);
  EXPECT_EQ(safety.force_factor, usual.forceFactor);
  EXPECT_EQ(safety.cap_stiffness != 0, usual.capStiffness);
  EXPECT_EQ(safety.maximum_stiffness, usual.maximumStiffness);
  EXPECT_EQ(safety.maximum_force_rate, usual.maximumForceRate);
  EXPECT_EQ(safety.maximum_force, usual.maximumForce);
  EXPECT_EQ(safety.control_passivity != 0, usual.controlPassivity);
  EXPECT_EQ(safety.period, usual.period);
  EXPECT_EQ(safety.sample_time_out, usual.sampleTimeOut);
}

TEST(CSafeContact, EachSafetyReachesTheChain)
{
  // With the links switched off one by one, the contact is the plain contact again.
  const CBall ball(3.0F);
  palpate_safety safety = usualSafety();
  safety.maximum_force = 5.0;
  safety.maximum_force_rate = 500.0;
  safety.maximum_stiffness = 2000.0;
  const auto deepest = [&]
  {
    const ContactHandle contact = makeContact(ball.c.get(), nullptr, safety);
    palpate_full_tick tick{};
    for (int i = 0; i <= 20; ++i)
    {
      palpate_sample sample;
      palpate_sample_default(&sample);
      sample.position[2] = 0.0199 - 4e-5 * i; // starts inside the body
      palpate_step_sample(contact.get(), &sample, 1e-3 * i, &tick);
    }
    return tick;
  };
  EXPECT_EQ(deepest().tick.device_force[2], 0.0); // the gate is closed
  safety.gate = 0;
  const palpate_full_tick capped = deepest();
  EXPECT_NE(capped.acted & PALPATE_STIFFNESS_CAP, 0U);
  EXPECT_LE(capped.tick.device_force[2], 2.0 * capped.tick.deflection); // the cap is 2 N/mm
  safety.cap_stiffness = 0;
  safety.control_passivity = 0;
  const palpate_full_tick clamped = deepest();
  EXPECT_EQ(clamped.acted & (PALPATE_STIFFNESS_CAP | PALPATE_PASSIVITY | PALPATE_GATE), 0U);
  EXPECT_NE(clamped.acted & PALPATE_MAGNITUDE, 0U);
  const double* sent = clamped.tick.device_force;
  EXPECT_NEAR(std::hypot(sent[0], sent[1], sent[2]), 5.0, 1e-12);
  safety.maximum_force = Infinity;
  safety.maximum_force_rate = Infinity;
  EXPECT_EQ(deepest().acted, 0U);
}

TEST(CSafeContact, WhatIsOutOfRangeIsRefusedByName)
{
  const CBall ball(1.0F);
  const palpate_safety good = usualSafety();
  EXPECT_EQ(refusal(ball.c.get(), nullptr, &good), "");
  EXPECT_EQ(refusal(nullptr, nullptr, &good), "no body is given");
  EXPECT_EQ(refusal(ball.c.get(), nullptr, nullptr), "no safety is given");
  struct Wrong
  {
    double palpate_safety::*member;
    double value;
    const char* reason;
  };
  const Wrong wrongs[] = {
    { &palpate_safety::force_factor, 0.0, "force_factor must be positive and at most 1, but is 0" },
    { &palpate_safety::force_factor, 1.5,
      "force_factor must be positive and at most 1, but is 1.5" },
    { &palpate_safety::maximum_force, -1.0, "maximum_force must not be negative (N), but is -1" },
    { &palpate_safety::maximum_stiffness, 0.0,
      "maximum_stiffness must be positive (N/m), but is 0" },
    { &palpate_safety::maximum_force_rate, NotANumber,
      "maximum_force_rate must be positive (N/s), but is nan" },
    { &palpate_safety::sample_time_out, 0.0, "sample_time_out must be positive (s), but is 0" },
    { &palpate_safety::period, Infinity, "period must be finite and positive (s), but is inf" },
    { &palpate_safety::entry_ramp, -0.5,
      "entry_ramp must be finite and not negative (s), but is -0.5" },
  };
  for (const Wrong& wrong : wrongs)
  {
    palpate_safety safety = good;
    safety.*wrong.member = wrong.value;
    EXPECT_EQ(refusal(ball.c.get(), nullptr, &safety), wrong.reason);
  }
  palpate_mapping mapping;
  palpate_mapping_default(&mapping);
  mapping.scale = -2.0;
  EXPECT_EQ(refusal(ball.c.get(), &mapping, &good), "scale must be finite and positive, but is -2");
  mapping.rotation[4] = 0.5;
  EXPECT_EQ(
    refusal(ball.c.get(), &mapping, &good), "rotation must be orthonormal, but RᵀR is off by 0.75");

  std::array<char, 256> reason{};
  EXPECT_EQ(palpate_scene_new(nullptr, nullptr, 1.0, reason.data(), reason.size()), nullptr);
  EXPECT_EQ(std::string(reason.data()), "no body is given");
  EXPECT_EQ(palpate_scene_new(ball.c.get(), nullptr, 2.0, reason.data(), reason.size()), nullptr);
  EXPECT_EQ(std::string(reason.data()), "force_factor must be positive and at most 1, but is 2");
  palpate_settings settings;
  palpate_settings_default(&settings);
  settings.force_form = 7;
  EXPECT_EQ(palpate_scene_new(ball.c.get(), &settings, 1.0, nullptr, 0), nullptr);
  palpate_scene_free(nullptr);
}

TEST(CSafeContact, FitsABodyOrSaysWhyNot)
{
  const CBall ball(1.0F);
  palpate_mapping mapping;
  palpate_mapping_default(&mapping);
  const double workspace[3] = { 0.1, 0.05, 0.2 };
  std::array<char, 256> reason{};
  ASSERT_EQ(
    palpate_mapping_fit(&mapping, ball.c.get(), workspace, 5.0, reason.data(), reason.size()), 1);
  // A ball of 20 mm with a margin of 5 mm is fitted into 50 mm. The tolerances allow for the
  // float32 mesh and its highest corner.
  EXPECT_NEAR(mapping.scale, 0.5, 1e-4);
  EXPECT_NEAR(
    std::hypot(mapping.translation[0], mapping.translation[1], mapping.translation[2]), 0.0, 1e-5);
  const double before = mapping.scale;
  const double flat[3] = { 0.1, 0.05, 0.0 };
  EXPECT_EQ(
    palpate_mapping_fit(&mapping, ball.c.get(), flat, 5.0, reason.data(), reason.size()), 0);
  EXPECT_EQ(std::string(reason.data()), "workspace must be finite and positive (m)");
  EXPECT_EQ(palpate_mapping_fit(
              &mapping, ball.c.get(), workspace, NotANumber, reason.data(), reason.size()),
    0);
  EXPECT_EQ(std::string(reason.data()).rfind("margin must be finite", 0), 0U);
  EXPECT_EQ(palpate_mapping_fit(&mapping, nullptr, workspace, 5.0, nullptr, 0), 0);
  EXPECT_EQ(mapping.scale, before) << "a refusal leaves it alone";
  mapping.planar = 1;
  EXPECT_EQ(palpate_mapping_fit(&mapping, ball.c.get(), flat, 5.0, nullptr, 0), 1);
}

TEST(CSafeContact, APlainContactStepsWithSamplesToo)
{
  const CBall ball(1.0F);
  const ContactHandle plain{ palpate_contact_new(ball.c.get(), 10.0), &palpate_contact_free };
  palpate_sample sample;
  palpate_sample_default(&sample);
  sample.position[2] = 0.0195;
  palpate_full_tick full;
  palpate_step_sample(plain.get(), &sample, 0.0, &full);
  palpate_tick tick;
  palpate_step(plain.get(), sample.position, 0.001, &tick);
  EXPECT_GT(tick.device_force[2], 1.0);
  EXPECT_EQ(full.tick.device_force[2], tick.device_force[2]);
  sample.valid = 0;
  palpate_step_sample(plain.get(), &sample, 0.002, &full);
  EXPECT_EQ(full.tick.device_force[2], 0.0);
  EXPECT_EQ(full.acted, static_cast<unsigned int>(PALPATE_NO_SAMPLE));
}

TEST(CSafeContact, ABodyMayBeFreedBeforeIt)
{
  CBall ball(1.0F);
  palpate_safety safety = usualSafety();
  safety.gate = 0;
  const ContactHandle contact = makeContact(ball.c.get(), nullptr, safety);
  palpate_change(contact.get(), palpate_scene_new(ball.c.get(), nullptr, 1.0, nullptr, 0));
  ball.c.reset();
  palpate_sample sample;
  palpate_sample_default(&sample);
  sample.position[2] = 0.0195;
  palpate_full_tick tick;
  palpate_step_sample(contact.get(), &sample, 0.0, &tick);
  EXPECT_EQ(tick.tick.state, PALPATE_SLIDE);
}
} // namespace c_safe_contact
