// SPDX-License-Identifier: BSD-3-Clause
// The C interface gives the numbers of ServoStep, and reasons instead of crashes.
#include "palpate.h"

#include "FlatBodyFile.h"
#include "SampleResponses.h"
#include "ServoStep.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

using namespace palpate::testing;

namespace
{
struct Exported
{
  Surface ball = icosphere(20.0, 3);
  ResponseStore store{ ball.points.size() };
  std::string path = ::testing::TempDir() + "palpate-c-interface.palpate";

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
  ~Exported() { std::remove(this->path.c_str()); }
};
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
    const palpate::ServoTick expected = servo.step(sample, t);
    palpate_tick tick;
    palpate_step(contact, sample.position.data(), t, &tick);
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
