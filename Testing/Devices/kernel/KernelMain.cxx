// SPDX-License-Identifier: BSD-3-Clause
// The first process of an emulated machine (boot.sh): prepares the system for the tests, runs them,
// prints their results on the console, and ends the machine.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace
{
bool failed(const char* what)
{
  std::printf("%s: %s\n", what, std::strerror(errno));
  return false;
}

bool mounted(const char* type, const char* place)
{
  mkdir(place, 0755); // the kernel has already created some of these folders
  return mount(type, place, type, 0, nullptr) == 0 || errno == EBUSY || failed(place);
}

bool loaded(const char* path)
{
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && syscall(SYS_finit_module, file, "", 0) == 0;
  if (!done)
  {
    failed(path);
  }
  close(file);
  return done;
}

bool prepared()
{
  return mounted("proc", "/proc") && mounted("sysfs", "/sys") && mounted("devtmpfs", "/dev") &&
    mounted("tmpfs", "/tmp") && loaded("/modules/hid.ko") && loaded("/modules/hid-generic.ko") &&
    loaded("/modules/uhid.ko");
}
} // namespace

int main(int argc, char* argv[])
{
  if (getpid() != 1)
  {
    std::printf("palpateKernelTests is the first process of an emulated machine: see boot.sh\n");
    return 77;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  testing::InitGoogleTest(&argc, argv);
  const int result = prepared() ? RUN_ALL_TESTS() : 1;
  const int ran = testing::UnitTest::GetInstance()->successful_test_count();
  std::printf("palpate kernel job: %s\n", result == 0 && ran > 0 ? "passed" : "failed");
  std::fflush(stdout);
  tcdrain(STDOUT_FILENO);
  reboot(RB_AUTOBOOT); // with -no-reboot the emulator ends instead of rebooting
  return 1;
}
