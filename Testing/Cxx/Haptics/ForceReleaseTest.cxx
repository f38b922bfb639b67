// SPDX-License-Identifier: BSD-3-Clause
// A process that is ended by an exception releases the force on the hand, if this was requested.
// The exception is thrown by a device in a tick, or in another thread. The test reads the error
// stream.
#include "Haptics/Safety/ForceRelease.h"
#include "SampleResponses.h"
#include "Haptics/Servo/ServoLoop.h"
#include "StandingDevice.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <thread>

using Eigen::Vector3d;
using namespace palpate;
using namespace palpate::testing;

namespace
{
void say(std::string_view text)
{
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// Writes a message when it receives zero force. May throw in its tenth reading.
class SpeakingDevice final : public StandingDevice
{
public:
  explicit SpeakingDevice(bool throwsInRead)
    : StandingDevice(Vector3d(0.0, 0.0, 0.0195))
    , Throws(throwsInRead)
  {
  }
  bool write(const Vector3d& force) noexcept override
  {
    if (!force.isZero())
    {
      this->Pressed = true;
    }
    else if (this->Pressed)
    {
      say("<let go>");
    }
    return true;
  }
  std::atomic<bool> Pressed{ false };

protected:
  void onRead(DeviceSample&, std::uint64_t number) override
  {
    if (this->Throws && number == 9)
    {
      throw std::runtime_error("<a device's>");
    }
  }

private:
  bool Throws;
};

/// Presses on a body until an exception ends the process.
[[noreturn]] void pressAndDie(bool releases, bool inTheTick)
{
  if (releases)
  {
    releaseForceOnTerminate();
    releaseForceOnTerminate(); // a second call has no effect
  }
  const auto body = uniformBody(icosphere(20.0, 3));
  SpeakingDevice device(inTheTick);
  ServoLoop loop(device, ServoStep(*body, WorkspaceMapping(), 10.0), 1000.0);
  loop.start();
  waitForTicks(loop, inTheTick ? ~std::uint64_t{ 0 } : 10);
  std::thread([] { throw std::runtime_error("<the program's>"); }).join(); // not caught
  std::abort();
}

class ForceReleaseDeathTest : public ::testing::Test
{
protected:
  ForceReleaseDeathTest() { ::testing::GTEST_FLAG(death_test_style) = "threadsafe"; }
};
} // namespace

TEST_F(ForceReleaseDeathTest, ADeviceThatThrowsIsGivenZeroForce)
{
  // Then the process ends as usual, with the message of the exception.
  EXPECT_DEATH(pressAndDie(true, true), "<let go>(.|\n)*<a device's>");
}

TEST_F(ForceReleaseDeathTest, AnExceptionElsewhereLetsTheServoThreadLetGo)
{
  EXPECT_DEATH(pressAndDie(true, false), "<let go>(.|\n)*<the program's>");
}

TEST_F(ForceReleaseDeathTest, WithoutTheCallNothingIsChanged)
{
  // The pattern begins at the start of the stream: there was no earlier message.
  EXPECT_DEATH(pressAndDie(false, true), "^terminate called(.|\n)*<a device's>");
}
