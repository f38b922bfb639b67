// SPDX-License-Identifier: BSD-3-Clause
// read and write of a bridge do not use the heap: with a live or silent program, during a new
// greeting, and when flooded.
#include "AllocationCount.h"
#include "Transports/Bridge/BridgeDevice.h"
#include "BridgePeer.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>

using namespace palpate;
using namespace palpate::testing;

namespace
{
void send(BridgePeer& peer, std::uint32_t sequence)
{
  StateReport state;
  state.sequence = sequence;
  HapticReportBytes bytes{};
  pack(state, bytes);
  peer.send(bytes.data(), bytes.size());
}

void describe(BridgePeer& peer, std::uint32_t nonce)
{
  DescriptionReport description;
  description.nonce = nonce;
  HapticReportBytes bytes{};
  pack(description, bytes);
  peer.send(bytes.data(), bytes.size());
}

/// Receives the pending datagrams and answers greetings. Returns the number of greetings.
int serve(BridgePeer& peer)
{
  int greetings = 0;
  HapticReportBytes bytes{};
  while (peer.receive(bytes) >= 0)
  {
    HelloReport hello;
    if (parse(bytes.data(), bytes.size(), hello) == ReportDefect::None)
    {
      describe(peer, hello.nonce);
      ++greetings;
    }
  }
  return greetings;
}
} // namespace

TEST(BridgeAllocation, NoneInTheTick)
{
  BridgePeer peer("udp:0");
  std::unique_ptr<BridgeDevice> device;
  std::string error;
  std::thread host([&] { device = BridgeDevice::open(peer.address(), error, 20.0); });
  while (serve(peer) == 0)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  host.join();
  ASSERT_TRUE(device) << error;
  int valid = 0;
  int again = 0;
  const long before = allocationCount();
  for (int i = 1; i <= 4000; ++i)
  {
    again += serve(peer);
    const bool silent = i % 1000 > 500;
    // Sometimes more reports than one tick reads.
    for (int j = 0; !silent && j < (i % 100 == 0 ? 100 : 1); ++j)
    {
      send(peer, static_cast<std::uint32_t>(200 * i + j));
    }
    valid += device->read(1e-3 * i).valid ? 1 : 0;
    device->write({ 0.0, i % 97 == 0 ? std::nan("") : 1.0, i % 7 == 0 ? 100.0 : 0.0 });
    device->errors();
  }
  EXPECT_EQ(allocationCount() - before, 0);
  EXPECT_GT(valid, 1000);
  EXPECT_GT(again, 3);
  EXPECT_EQ(device->errors().disconnections, 4U);
}
