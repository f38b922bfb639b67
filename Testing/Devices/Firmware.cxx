// SPDX-License-Identifier: BSD-3-Clause
#include "Firmware.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

namespace palpate::testing
{
palpate_hid_description describedDevice()
{
  palpate_hid_description description{};
  description.outputs_force = true;
  description.maximum_force = 6.0F;
  description.maximum_stiffness = 2500.0F;
  description.maximum_force_rate = 4000.0F;
  description.maximum_damping = 8.0F;
  description.half_extents[0] = description.half_extents[1] = description.half_extents[2] = 0.08F;
  description.rate = 1000.0F;
  description.sample_time_out = 0.02F;
  std::memcpy(description.name, "Palpate test", 12);
  return description;
}

HidModel modelOf(const palpate_hid_description& description)
{
  HidModel model;
  model.reportDescriptor.assign(
    palpate_hid_report_descriptor, palpate_hid_report_descriptor + PALPATE_HID_DESCRIPTOR_SIZE);
  model.feature.resize(PALPATE_HID_REPORT_SIZE);
  palpate_hid_describe(&description, 0, model.feature.data());
  return model;
}

Firmware::Firmware(EmulatedHid& hid, HandPath hand)
  : Hid(hid)
  , Hand(std::move(hand))
{
  palpate_hid_start(&this->State, 6.0F, 20000);
  this->Thread = std::thread([this] { this->run(); });
}

Firmware::~Firmware()
{
  this->Stopping = true;
  this->Thread.join();
}

void Firmware::run()
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  auto deadline = begin;
  while (!this->Stopping)
  {
    this->tick(static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin).count()));
    deadline += std::chrono::milliseconds(1);
    std::this_thread::sleep_until(deadline);
  }
}

void Firmware::tick(std::uint64_t now)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Hanging)
  {
    return;
  }
  std::vector<std::uint8_t> bytes;
  while (this->Hid.receive(bytes, PALPATE_HID_REPORT_SIZE))
  {
    if (palpate_hid_receive(&this->State, bytes.data(), bytes.size(), now))
    {
      std::uint32_t restsOn = 0;
      std::memcpy(
        &restsOn, bytes.data() + 32, sizeof restsOn); // the test's machine is little-endian
      this->Delays.push_back(this->State.sequence - restsOn);
      ++this->Taken;
    }
  }
  float force[3];
  palpate_hid_force(&this->State, now, force);
  this->Motors = Eigen::Vector3f(force[0], force[1], force[2]).cast<double>();
  if (this->Applied.empty() || this->Applied.back() != this->Motors)
  {
    this->Applied.push_back(this->Motors);
  }

  palpate_hid_reading reading{};
  const Eigen::Vector3f position = this->Hand(1e-6 * static_cast<double>(now)).cast<float>();
  std::memcpy(reading.position, position.data(), sizeof reading.position);
  std::uint8_t report[PALPATE_HID_REPORT_SIZE];
  palpate_hid_state(&this->State, now, &reading, report);
  this->NotSent += this->Hid.send(report, sizeof report) ? 0 : 1;
}

void Firmware::hang(bool yes)
{
  const std::lock_guard<std::mutex> lock(this->Mutex); // waits for the end of a running tick
  this->Hanging = yes;
}

palpate_hid Firmware::state() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->State;
}

Eigen::Vector3d Firmware::motors() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Motors;
}

bool Firmware::hasApplied(const Eigen::Vector3d& force) const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::find(this->Applied.begin(), this->Applied.end(), force) != this->Applied.end();
}

std::uint64_t Firmware::forcesTaken() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Taken;
}

std::uint64_t Firmware::statesNotSent() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->NotSent;
}

std::vector<std::uint32_t> Firmware::delays() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Delays;
}
} // namespace palpate::testing
