// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Files/TrialRun.h"

#include "vtkSMPTools.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <new>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr char Finished = 1;
constexpr char OutOfMemory = 2;

/// Returns the number of bytes of address space that the process uses.
double usedAddresses()
{
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void limitMemory(double memory)
{
  rlimit limit = {};
  const double wanted = usedAddresses() + memory;
  if (getrlimit(RLIMIT_AS, &limit) == 0 && wanted < static_cast<double>(limit.rlim_max) &&
    wanted < static_cast<double>(limit.rlim_cur))
  {
    limit.rlim_cur = static_cast<rlim_t>(wanted);
    setrlimit(RLIMIT_AS, &limit);
  }
}

/// Suppresses the effects of a crash: no core file, no output, no signal handlers of the program.
void prepareToCrash()
{
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  const int null = open("/dev/null", O_WRONLY);
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  for (const int signal : { SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGHUP })
  {
    std::signal(signal, SIG_DFL);
  }
  std::set_terminate([] { std::abort(); });
  // Sequential, because the copy of the process has no other threads.
  vtkSMPTools::SetBackend("Sequential");
}
} // namespace

std::string crashOf(const std::function<void()>& work, double memory)
{
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) != 0)
  {
    return std::strerror(errno);
  }
  const pid_t copy = fork();
  if (copy == 0)
  {
    prepareToCrash();
    limitMemory(memory);
    char end = Finished;
    try
    {
      work();
    }
    catch (const std::bad_alloc&)
    {
      end = OutOfMemory;
    }
    catch (...) // the same exception will occur in the calling process
    {
    }
    _exit(write(pipe[1], &end, 1) == 1 ? 0 : 1);
  }
  const std::string failed = copy < 0 ? std::strerror(errno) : "";
  close(pipe[1]);
  char end = 0;
  while (copy > 0 && read(pipe[0], &end, 1) < 0 && errno == EINTR)
  {
  }
  close(pipe[0]);
  int status = 0;
  while (copy > 0 && waitpid(copy, &status, 0) < 0 && errno == EINTR)
  {
  }
  if (copy < 0 || end == Finished)
  {
    return failed;
  }
  if (end == OutOfMemory)
  {
    return "out of memory";
  }
  return WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "it ended early";
}
} // namespace palpate
