// SPDX-License-Identifier: BSD-3-Clause
// The report of the permitted scheduling agrees with the state of the system, for granted and for
// refused requests. Capabilities belong to a thread, so a test can drop its own capabilities.
#include "Haptics/Servo/RealTimeGrant.h"

#include "ProcessMemory.h"
#include "Sanitized.h"

#include <gtest/gtest.h>

#include <linux/capability.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <functional>
#include <string>
#include <thread>

using palpate::RealTimeGrant;
using palpate::RealTimeRequest;
using palpate::requestRealTime;
using palpate::testing::lockedMemory;

namespace
{
/// Request, report and state of a thread.
struct Asked
{
  RealTimeGrant grant;
  int policy = -1;
  int priority = -1;
  int slack = -1; ///< ns
};

Asked askInAThread(
  const RealTimeRequest& request, const std::function<void()>& before = [] {})
{
  Asked asked;
  std::thread thread(
    [&]
    {
      before();
      asked.grant = requestRealTime(request);
      asked.policy = sched_getscheduler(0);
      sched_param parameter{};
      sched_getparam(0, &parameter);
      asked.priority = parameter.sched_priority;
      asked.slack = prctl(PR_GET_TIMERSLACK, 0UL, 0UL, 0UL, 0UL);
    });
  thread.join();
  return asked;
}

void giveUpCapabilities()
{
  __user_cap_header_struct header{};
  header.version = _LINUX_CAPABILITY_VERSION_3;
  const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
  ASSERT_EQ(syscall(SYS_capset, &header, none.data()), 0);
}

/// Changes a limit of the process during its lifetime.
class Limit
{
public:
  Limit(int which, rlim_t value)
    : Which(which)
  {
    getrlimit(static_cast<__rlimit_resource_t>(which), &this->Before);
    const rlimit changed{ value, std::max(value, this->Before.rlim_max) };
    this->Set = setrlimit(static_cast<__rlimit_resource_t>(which), &changed) == 0;
  }
  ~Limit() { setrlimit(static_cast<__rlimit_resource_t>(this->Which), &this->Before); }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;

  bool isSet() const { return this->Set; }

private:
  int Which;
  rlimit Before{};
  bool Set = false;
};
} // namespace

TEST(RealTimeGrant, TheSchedulingReportedIsTheOneTheThreadHas)
{
  const Asked asked = askInAThread(RealTimeRequest());
  EXPECT_EQ(asked.policy, asked.grant.priority > 0 ? SCHED_FIFO : SCHED_OTHER);
  EXPECT_EQ(asked.priority, asked.grant.priority);
  EXPECT_EQ(asked.grant.priority == 80, asked.grant.priorityError == 0);
  EXPECT_TRUE(asked.grant.timerSlack);
  EXPECT_FALSE(asked.grant.memoryLocked);
}

TEST(RealTimeGrant, NothingIsChangedThatWasNotAskedFor)
{
  RealTimeRequest request;
  request.priority = 0;
  const double before = lockedMemory();
  const Asked asked = askInAThread(request);
  EXPECT_EQ(asked.policy, SCHED_OTHER);
  EXPECT_EQ(asked.slack, 1);
  EXPECT_EQ(lockedMemory(), before);
  EXPECT_EQ(asked.grant.describe(),
    "SCHED_FIFO not requested; memory not locked: not requested; timer slack 1 ns");
}

TEST(RealTimeGrant, ARefusalSaysWhy)
{
  const Limit none(RLIMIT_RTPRIO, 0);
  const Limit little(RLIMIT_MEMLOCK, 65536);
  ASSERT_TRUE(none.isSet() && little.isSet());
  RealTimeRequest request;
  request.lockMemory = true;
  const Asked asked = askInAThread(request, giveUpCapabilities);
  EXPECT_EQ(asked.policy, SCHED_OTHER);
  EXPECT_EQ(asked.grant.priority, 0);
  EXPECT_EQ(asked.grant.priorityError, EPERM);
  EXPECT_FALSE(asked.grant.memoryLocked);
  EXPECT_EQ(asked.slack, 1);
  EXPECT_EQ(asked.grant.describe(),
    "SCHED_FIFO 80 refused: Operation not permitted; memory not locked: Operation not permitted; "
    "timer slack 1 ns");
}

TEST(RealTimeGrant, ALimitBelowTheRequestIsUsed)
{
  const Limit ten(RLIMIT_RTPRIO, 10);
  if (!ten.isSet())
  {
    GTEST_SKIP() << "the limit of real-time priorities may not be raised here";
  }
  const Asked asked = askInAThread(RealTimeRequest(), giveUpCapabilities);
  EXPECT_EQ(asked.policy, SCHED_FIFO);
  EXPECT_EQ(asked.priority, 10);
  EXPECT_EQ(asked.grant.priority, 10);
  EXPECT_EQ(asked.grant.describe(),
    "SCHED_FIFO 80 refused: Operation not permitted, SCHED_FIFO 10 granted; memory not locked: "
    "not requested; timer slack 1 ns");
}

TEST(RealTimeGrant, APriorityThatThereIsNotIsRefused)
{
  RealTimeRequest request;
  request.priority = 100;
  const Asked asked = askInAThread(request);
  EXPECT_EQ(asked.policy, SCHED_OTHER);
  EXPECT_EQ(asked.grant.priority, 0);
  EXPECT_EQ(asked.grant.priorityError, EINVAL);
}

TEST(RealTimeGrant, MemoryIsLockedOrItIsSaidWhyNot)
{
  RealTimeRequest request;
  request.lockMemory = true;
  const Asked asked = askInAThread(request);
  EXPECT_EQ(asked.grant.memoryLocked, asked.grant.memoryError == 0);
#ifndef PALPATE_SANITIZED
  EXPECT_EQ(lockedMemory() > 0.0, asked.grant.memoryLocked); // no effect with sanitizers
#endif
  munlockall();
}
