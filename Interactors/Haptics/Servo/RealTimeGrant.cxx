// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/RealTimeGrant.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>

#ifdef __linux__
#include <linux/capability.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace palpate
{
namespace
{
std::string reason(int error)
{
  return std::generic_category().message(error);
}

#ifdef __linux__
int setFifo(int priority) noexcept
{
  sched_param parameter{};
  parameter.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
}

void requestFifo(RealTimeGrant& grant) noexcept
{
  const int wanted = grant.request.priority;
  if (wanted == 0)
  {
    return;
  }
  grant.priorityError = setFifo(wanted);
  if (grant.priorityError == 0)
  {
    grant.priority = wanted;
    return;
  }
  rlimit limit{};
  if (grant.priorityError == EPERM && getrlimit(RLIMIT_RTPRIO, &limit) == 0 && limit.rlim_cur > 0 &&
    limit.rlim_cur < static_cast<rlim_t>(wanted))
  {
    const int allowed = static_cast<int>(limit.rlim_cur);
    grant.priority = setFifo(allowed) == 0 ? allowed : 0;
  }
}

/// Whether locked memory is not limited for this process.
bool mayLockAll() noexcept
{
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY)
  {
    return true;
  }
  __user_cap_header_struct header{};
  header.version = _LINUX_CAPABILITY_VERSION_3;
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> sets{};
  return syscall(SYS_capget, &header, sets.data()) == 0 &&
    (sets[CAP_TO_INDEX(CAP_IPC_LOCK)].effective & CAP_TO_MASK(CAP_IPC_LOCK)) != 0;
}

void requestMemory(RealTimeGrant& grant) noexcept
{
  if (!grant.request.lockMemory)
  {
    return;
  }
  if (!mayLockAll())
  {
    grant.memoryError = EPERM;
    return;
  }
  grant.memoryLocked = mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
  grant.memoryError = grant.memoryLocked ? 0 : errno;
}
#endif

#if defined(__GNUC__)
__attribute__((noinline))
#endif
void touchStack() noexcept
{
  constexpr std::size_t Bytes = 64 * 1024;
  constexpr std::size_t Page = 4096;
  std::array<unsigned char, Bytes> stack;
  volatile unsigned char* const memory =
    stack.data(); // volatile, so that the compiler does not remove the writes
  for (std::size_t i = 0; i < Bytes; i += Page)
  {
    memory[i] = 0;
  }
}
} // namespace

std::string RealTimeGrant::describe() const
{
  std::string text;
  const std::string wanted = "SCHED_FIFO " + std::to_string(this->request.priority);
  if (this->request.priority == 0)
  {
    text = "SCHED_FIFO not requested";
  }
  else if (this->priority == this->request.priority)
  {
    text = wanted + " granted";
  }
  else
  {
    text = wanted + " refused: " + reason(this->priorityError);
    if (this->priority > 0)
    {
      text += ", SCHED_FIFO " + std::to_string(this->priority) + " granted";
    }
  }
  if (this->memoryLocked)
  {
    text += "; memory locked";
  }
  else
  {
    text += "; memory not locked: " +
      (this->request.lockMemory ? reason(this->memoryError) : std::string("not requested"));
  }
  return text + (this->timerSlack ? "; timer slack 1 ns" : "; timer slack of the system");
}

RealTimeGrant requestRealTime(const RealTimeRequest& request) noexcept
{
  RealTimeGrant grant;
  grant.request = request;
#ifdef __linux__
  grant.timerSlack = prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) == 0;
  requestFifo(grant);
  requestMemory(grant);
#else
  grant.priorityError = request.priority != 0 ? ENOSYS : 0;
  grant.memoryError = request.lockMemory ? ENOSYS : 0;
#endif
  touchStack();
  return grant;
}
} // namespace palpate
