// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_ScratchFile_h
#define palpate_testing_ScratchFile_h

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace palpate::testing
{
/// Path of a file of the running test. If the test has written the file, the destructor removes it.
/// The tests of one executable run at the same time in separate processes, so two tests must not
/// share a name.
class ScratchFile
{
public:
  /// `ending`: for example ".csv".
  explicit ScratchFile(const std::string& ending)
  {
    const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
    this->Path =
      ::testing::TempDir() + "palpate-" + test->test_suite_name() + "-" + test->name() + ending;
  }
  ~ScratchFile() { std::remove(this->Path.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return this->Path; }

private:
  std::string Path;
};
} // namespace palpate::testing

#endif
