// SPDX-License-Identifier: BSD-3-Clause
// The C interface gives the same numbers as ServoStep. For wrong input it reports the reason and
// does not crash.
#include "Haptics/palpate.h"

#include "Contact/FlatBodyFile.h"
#include "Contact/ContactSettings.h"
#include "SampleResponses.h"
#include "ScratchFile.h"
#include "Haptics/Servo/ServoStep.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

using namespace palpate::testing;

namespace
{
struct Exported
{
  Surface ball = icosphere(20.0, 3);
  ResponseStore store{ ball.points.size() };
  ScratchFile scratch{ ".palpate" };
  const std::string& path = this->scratch.path();

  Exported()
  {
    this->store.normalsFromPoints(this->ball);
    const std::vector<float> validity(this->ball.points.size(), 1.0F);
    const std::vector<std::uint8_t> limit(this->ball.points.size(), 0);
    palpate::FlatBody body;
    body.points = this->ball.points.size();
    body.triangles = this->ball.triangles.size();
    body.coordinates = this->ball.points.front().data();
    body.corners = this->ball.triangles.front().data();
    body.response = this->store.arrays();
    body.validity = validity.data();
    body.limit = limit.data();
    EXPECT_EQ(palpate::FlatBodyFile::write(this->path, body), "");
  }
};

using BodyHandle = std::unique_ptr<palpate_body, decltype(&palpate_body_free)>;
using ContactHandle = std::unique_ptr<palpate_contact, decltype(&palpate_contact_free)>;

BodyHandle load(const Exported& file)
{
  return { palpate_body_load(file.path.c_str(), nullptr, 0), &palpate_body_free };
}

/// Returns the reason for refusing the settings; "" if they are accepted.
std::string refusal(const palpate_body* body, const palpate_settings& settings)
{
  std::array<char, 256> reason{};
  const ContactHandle contact{ palpate_contact_new_with(
                                 body, 10.0, &settings, reason.data(), reason.size()),
    &palpate_contact_free };
  EXPECT_EQ(contact == nullptr, reason[0] != '\0');
  return reason.data();
}
} // namespace

TEST(CInterface, StepsAsServoStepDoes)
{
  const Exported file;
  palpate_body* body = palpate_body_load(file.path.c_str(), nullptr, 0);
  ASSERT_NE(body, nullptr);
  palpate_contact* contact = palpate_contact_new(body, 10.0);
  ASSERT_NE(contact, nullptr);
  const auto kernel = contactBody(file.ball, file.store);
  palpate::ServoStep servo(*kernel, palpate::WorkspaceMapping(), 10.0);
  int touching = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const double t = 1e-3 * i;
    palpate::DeviceSample sample;
    sample.position =
      1e-3 * (20.0 - 1.5 * std::sin(20.0 * t)) * palpate::Vector3(std::cos(t), std::sin(t), 0.0);
    sample.valid = true;
    const palpate::Tick expected = servo.step(sample, t);
    palpate_tick tick;
    palpate_step(contact, sample.position.data(), t, &tick);
    palpate_foresee(contact); // must have no effect
    EXPECT_EQ(tick.state, static_cast<int>(expected.contact.state));
    EXPECT_EQ(tick.deflection, expected.contact.deflection);
    EXPECT_EQ(tick.normal_force, expected.contact.normalForce);
    EXPECT_EQ(tick.triangle, expected.contact.triangle);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(tick.device_force[k], expected.deviceForce[k]);
      EXPECT_EQ(tick.force[k], expected.contact.force[k]);
      EXPECT_EQ(tick.contact_point[k], expected.contact.contactPoint[k]);
    }
    touching += tick.triangle >= 0;
  }
  EXPECT_GT(touching, 300);
  palpate_contact_free(contact);
  palpate_body_free(body);
}

TEST(CInterface, StepsWithAPoseAsServoStepDoes)
{
  const Exported file;
  const BodyHandle body = load(file);
  const ContactHandle contact{ palpate_contact_new(body.get(), 10.0), &palpate_contact_free };
  const auto kernel = contactBody(file.ball, file.store);
  palpate::ServoStep servo(*kernel, palpate::WorkspaceMapping(), 10.0);
  EXPECT_EQ(PALPATE_TILTED_TOO_FAR, static_cast<int>(palpate::ContactState::TiltedTooFar));
  palpate_tick tick;
  for (int i = 0; i < 100; ++i)
  {
    palpate::DeviceSample sample;
    sample.position = palpate::Vector3(0.0, 0.0, 0.0201 - 1e-5 * i);
    const palpate::Vector3 axis =
      i % 10 == 0 ? palpate::Vector3(0.0, 0.0, 0.0) : palpate::Vector3(0.2, 0.01 * i, 2.0);
    sample.orientation = palpate::orientationAlong(axis);
    sample.valid = true;
    const palpate::Tick expected = servo.step(sample, 1e-3 * i);
    palpate_step_pose(contact.get(), sample.position.data(), axis.data(), 1e-3 * i, &tick);
    ASSERT_EQ(tick.state, static_cast<int>(expected.contact.state));
    EXPECT_EQ(tick.tilt, expected.contact.tilt);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(tick.device_force[k], expected.deviceForce[k]);
      EXPECT_EQ(tick.torque[k], expected.contact.torque[k]);
    }
  }
  EXPECT_GT(tick.normal_force, 0.0);
  const double position[3] = { 0.0, 0.0, 0.0199 };
  const double wrong[3] = { 0.0, std::numeric_limits<double>::infinity(), 1.0 };
  palpate_step_pose(contact.get(), position, wrong, 1.0, &tick);
  EXPECT_EQ(tick.state, PALPATE_INVALID);
  EXPECT_EQ(tick.device_force[2], 0.0);
}

TEST(CInterface, APositionThatIsNotFiniteGivesZeroForce)
{
  const Exported file;
  palpate_body* body = palpate_body_load(file.path.c_str(), nullptr, 0);
  palpate_contact* contact = palpate_contact_new(body, 10.0);
  const double deep[3] = { 0.0, 0.0, 0.0195 };
  const double lost[3] = { 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0 };
  palpate_tick tick;
  palpate_step(contact, deep, 0.0, &tick);
  EXPECT_GT(tick.device_force[2], 0.0);
  palpate_step(contact, lost, 0.001, &tick);
  EXPECT_EQ(tick.state, PALPATE_INVALID);
  EXPECT_EQ(tick.device_force[2], 0.0);
  palpate_reset(contact);
  palpate_step(contact, deep, 0.002, &tick);
  EXPECT_EQ(tick.state, PALPATE_SLIDE);
  palpate_contact_free(contact);
  palpate_body_free(body);
}

TEST(CInterface, ReasonsAreGivenAndCutToTheSpaceThereIs)
{
  std::array<char, 256> reason{};
  EXPECT_EQ(palpate_body_load("/no/such/file.palpate", reason.data(), reason.size()), nullptr);
  EXPECT_NE(std::string(reason.data()).find("/no/such/file.palpate"), std::string::npos);
  std::array<char, 8> little;
  little.fill('x');
  EXPECT_EQ(palpate_body_load("/no/such/file.palpate", little.data(), little.size()), nullptr);
  EXPECT_EQ(std::string(little.data()).size(), 7U);
  EXPECT_EQ(palpate_body_load(nullptr, reason.data(), reason.size()), nullptr);
  EXPECT_EQ(palpate_body_load("/no/such/file.palpate", nullptr, 0), nullptr);
  EXPECT_EQ(palpate_contact_new(nullptr, 1.0), nullptr);
  palpate_body_free(nullptr);
  palpate_contact_free(nullptr);
}

TEST(CInterface, EachSettingReachesTheContact)
{
  const Exported file;
  const BodyHandle body = load(file);
  const auto kernel = contactBody(file.ball, file.store);
  for (int variant = 0; variant < 4; ++variant)
  {
    palpate_settings settings;
    palpate_settings_default(&settings);
    settings.force_form = variant % 3;
    settings.contact_surface = variant % 2;
    settings.friction_model = (variant + 1) % 3;
    settings.friction_coefficient = 0.3 + 0.1 * variant;
    settings.tangential_stiffness = 2.0 + variant;
    settings.friction_breakaway = 0.5 + 0.1 * variant;
    settings.friction_stick_radius = 0.95;
    settings.poisson_ratio = 0.1 * variant;
    palpate::ContactSettings same;
    same.form = static_cast<palpate::ForceForm>(settings.force_form);
    same.surface = static_cast<palpate::ContactSurface>(settings.contact_surface);
    same.friction = { static_cast<palpate::FrictionModel>(settings.friction_model),
      settings.friction_coefficient, settings.tangential_stiffness, settings.friction_breakaway,
      settings.friction_stick_radius, settings.poisson_ratio };
    const ContactHandle contact{ palpate_contact_new_with(body.get(), 10.0, &settings, nullptr, 0),
      &palpate_contact_free };
    ASSERT_NE(contact, nullptr);
    palpate::ServoStep servo(*kernel, palpate::WorkspaceMapping(), 10.0, same);
    for (int i = 0; i < 400; ++i)
    {
      const double t = 1e-3 * i;
      palpate::DeviceSample sample;
      sample.position =
        1e-3 * (20.0 - 1.5 * std::sin(20.0 * t)) * palpate::Vector3(std::cos(t), std::sin(t), 0.0);
      sample.valid = true;
      const palpate::Tick expected = servo.step(sample, t);
      palpate_tick tick;
      palpate_step(contact.get(), sample.position.data(), t, &tick);
      ASSERT_EQ(tick.state, static_cast<int>(expected.contact.state));
      ASSERT_EQ(tick.normal_force, expected.contact.normalForce);
      for (int k = 0; k < 3; ++k)
      {
        ASSERT_EQ(tick.device_force[k], expected.deviceForce[k]);
        ASSERT_EQ(tick.force[k], expected.contact.force[k]);
        ASSERT_EQ(tick.friction[k], expected.contact.friction[k]);
      }
    }
  }
}

TEST(CInterface, DefaultsAreThoseOfTheKernel)
{
  palpate_settings settings;
  palpate_settings_default(&settings);
  const palpate::ContactSettings usual;
  EXPECT_EQ(settings.force_form, static_cast<int>(usual.form));
  EXPECT_EQ(settings.contact_surface, static_cast<int>(usual.surface));
  EXPECT_EQ(settings.friction_model, static_cast<int>(usual.friction.model));
  EXPECT_EQ(settings.friction_coefficient, usual.friction.coefficient);
  EXPECT_EQ(settings.tangential_stiffness, usual.friction.tangentialStiffness);
  EXPECT_EQ(settings.friction_breakaway, usual.friction.breakaway);
  EXPECT_EQ(settings.friction_stick_radius, usual.friction.stickRadius);
  EXPECT_EQ(settings.poisson_ratio, usual.friction.poissonRatio);
  EXPECT_EQ(PALPATE_PAPER, static_cast<int>(palpate::ForceForm::Paper));
  EXPECT_EQ(
    PALPATE_NORMALIZED_DIRECTION, static_cast<int>(palpate::ForceForm::NormalizedDirection));
  EXPECT_EQ(PALPATE_ENERGY_CONSISTENT, static_cast<int>(palpate::ForceForm::EnergyConsistent));
  EXPECT_EQ(PALPATE_FACETS, static_cast<int>(palpate::ContactSurface::Facets));
  EXPECT_EQ(PALPATE_SMOOTH, static_cast<int>(palpate::ContactSurface::Smooth));
  EXPECT_EQ(PALPATE_ELASTO_PLASTIC, static_cast<int>(palpate::FrictionModel::ElastoPlastic));
  EXPECT_EQ(PALPATE_DAHL, static_cast<int>(palpate::FrictionModel::Dahl));
  EXPECT_EQ(PALPATE_SHAPE_DERIVED, static_cast<int>(palpate::FrictionModel::ShapeDerived));
}

TEST(CInterface, WrongSettingsAreNamed)
{
  const Exported file;
  const BodyHandle body = load(file);
  const auto said = [&](auto member, auto value)
  {
    palpate_settings settings;
    palpate_settings_default(&settings);
    settings.*member = value;
    return refusal(body.get(), settings);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(said(&palpate_settings::force_form, 2), "");
  EXPECT_EQ(said(&palpate_settings::force_form, 3),
    "force_form must be 0 (Paper), 1 (NormalizedDirection) or 2 (EnergyConsistent), but is 3");
  EXPECT_EQ(said(&palpate_settings::contact_surface, -1),
    "contact_surface must be 0 (Facets) or 1 (Smooth), but is -1");
  EXPECT_EQ(said(&palpate_settings::friction_model, 9),
    "friction_model must be 0 (ElastoPlastic), 1 (Dahl) or 2 (ShapeDerived), but is 9");
  EXPECT_EQ(said(&palpate_settings::friction_coefficient, nan),
    "friction_coefficient must be finite and not negative, but is nan");
  EXPECT_EQ(said(&palpate_settings::tangential_stiffness, 0.0),
    "tangential_stiffness must be finite and positive (N/mm), but is 0");
  EXPECT_EQ(said(&palpate_settings::friction_breakaway, -0.5),
    "friction_breakaway must lie between 0 and 1, but is -0.5");
  EXPECT_NE(
    said(&palpate_settings::friction_stick_radius, 0.1).find("friction_stick_radius must be"),
    std::string::npos);
  EXPECT_EQ(said(&palpate_settings::poisson_ratio, 0.75),
    "poisson_ratio must lie between 0 and 0.5, but is 0.75");
  std::array<char, 64> reason{};
  EXPECT_EQ(palpate_contact_new_with(nullptr, 1.0, nullptr, reason.data(), reason.size()), nullptr);
  EXPECT_STREQ(reason.data(), "no body is given");
}

TEST(CInterface, TellsItsVersion)
{
  EXPECT_STREQ(palpate_version(), PALPATE_VERSION_STRING);
  EXPECT_EQ(palpate_api_version(), PALPATE_API_VERSION);
}

// The sizes in PALPATE_API_VERSION 1, counted by hand, for pointers and doubles of eight bytes.
// The sizes must not change, so that a compiled program continues to work. New members take their
// space from `reserved`.
TEST(CInterface, StructsKeepTheirSizes)
{
  static_assert(sizeof(double) == 8 && sizeof(int) == 4);
  EXPECT_EQ(sizeof(palpate_settings), 3 * 4 + 4 + 5 * 8 + 8 * 8);
  EXPECT_EQ(sizeof(palpate_tick), (6 * 3 + 2) * 8 + 2 * 4 + 8 * 8);
  EXPECT_EQ(sizeof(palpate_mapping), (9 + 3 + 1) * 8 + 4 + 4 + 4 * 8);
  EXPECT_EQ(sizeof(palpate_device), (5 + 4) * 8);
  EXPECT_EQ(sizeof(palpate_safety), 4 + 4 + 2 * 8 + 4 + 4 + 3 * 8 + 4 + 4 + 2 * 8 + 8 * 8);
  EXPECT_EQ(sizeof(palpate_sample), 6 * 8 + 3 * 4 + 4 + 8 * 8);
  EXPECT_EQ(sizeof(palpate_full_tick), sizeof(palpate_tick) + (3 * 3 + 2) * 8 + 4 * 4 + 8 * 8);
}

TEST(CInterface, RefusesWhatALaterHeaderAsks)
{
  const Exported file;
  const BodyHandle body = load(file);
  palpate_settings settings;
  palpate_settings_default(&settings);
  EXPECT_EQ(refusal(body.get(), settings), "");
  for (double& member : settings.reserved)
  {
    EXPECT_EQ(member, 0.0);
    member = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal(body.get(), settings).find("palpate_settings.reserved"), std::string::npos);
    member = 0.0;
  }
}
