// SPDX-License-Identifier: BSD-3-Clause
// A file is replaced by a complete new one or stays unchanged.
#include "Mechanics/Files/WholeFile.h"

#include "FileSizeLimit.h"
#include "ScratchFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace palpate;
using namespace palpate::testing;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
const std::string Line = "0123456789\n";

std::string contentOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string lines(std::size_t count)
{
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
  {
    text += Line;
  }
  return text;
}

/// A test with a file that has content, and with no other file next to it.
class WholeFileTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    std::ofstream(this->path()) << "old";
    fs::remove(this->part());
  }
  void TearDown() override { fs::remove(this->part()); }
  const std::string& path() const { return this->Scratch.path(); }
  std::string part() const { return this->path() + ".part"; }

private:
  ScratchFile Scratch{ ".txt" };
};
} // namespace

TEST_F(WholeFileTest, TheOldOneStandsUntilTheNewOneIsWhole)
{
  WholeFile file(this->path());
  ASSERT_EQ(file.open(), "");
  file.write("new");
  EXPECT_EQ(contentOf(this->path()), "old");
  EXPECT_EQ(contentOf(file.unfinished()), "new");
  EXPECT_EQ(file.finish(), "");
  EXPECT_EQ(contentOf(this->path()), "new");
  EXPECT_FALSE(fs::exists(this->part()));
}

TEST_F(WholeFileTest, WhatWasNotFinishedLeavesNothing)
{
  {
    WholeFile file(this->path());
    ASSERT_EQ(file.open(), "");
    file.write("new");
  }
  EXPECT_EQ(contentOf(this->path()), "old");
  EXPECT_FALSE(fs::exists(this->part()));
}

TEST_F(WholeFileTest, AFullDiskIsToldAndTheOldOneStands)
{
  const FileSizeLimit full(1005);
  {
    WholeFile file(this->path());
    ASSERT_EQ(file.open(), "");
    file.write(lines(50)); // these lines still fit
    file.write(lines(1000));
    file.write("and then for nothing");
    EXPECT_EQ(file.finish(), "cannot write '" + this->path() + "': " + FileTooLarge);
    EXPECT_EQ(contentOf(this->path()), "old");
  }
  EXPECT_FALSE(fs::exists(this->part()));
}

TEST_F(WholeFileTest, WholeLinesCanBeKept)
{
  const FileSizeLimit full(1005); // 91 lines of 11 bytes, and a part of the next
  {
    WholeFile file(this->path());
    ASSERT_EQ(file.open(), "");
    file.write(lines(1000));
    ASSERT_NE(file.finish(), "");
    EXPECT_EQ(file.keepLines(91), 91U);
  }
  EXPECT_EQ(contentOf(this->part()), lines(91));
  EXPECT_EQ(contentOf(this->path()), "old");
  {
    WholeFile file(this->path());
    ASSERT_EQ(file.open(), "");
    file.write(lines(1000));
    ASSERT_NE(file.finish(), "");
    EXPECT_EQ(file.keepLines(92), 0U) << "too few to be of use";
  }
  EXPECT_FALSE(fs::exists(this->part()));
}

TEST_F(WholeFileTest, WhatIsNoFileIsWrittenToAndStays)
{
  for (const std::string device : { "/dev/full", "/dev/null" })
  {
    WholeFile file(device);
    ASSERT_EQ(file.open(), "");
    EXPECT_FALSE(file.isFile());
    file.write("new");
    EXPECT_EQ(file.finish(),
      device == "/dev/null" ? "" : "cannot write '/dev/full': No space left on device");
    EXPECT_EQ(file.keepLines(0), 0U);
    EXPECT_TRUE(fs::is_character_file(device));
    EXPECT_FALSE(fs::exists(device + ".part"));
  }
}

TEST_F(WholeFileTest, ALinkIsFollowed)
{
  const std::string link = this->path() + ".link";
  fs::remove(link);
  fs::create_symlink(this->path(), link);
  WholeFile file(link);
  ASSERT_EQ(file.open(), "");
  EXPECT_EQ(file.unfinished(), fs::canonical(this->path()).string() + ".part");
  file.write("new");
  EXPECT_EQ(file.finish(), "");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(contentOf(this->path()), "new");
  fs::remove(link);
}

TEST_F(WholeFileTest, WhatIsInTheWayIsToldBeforeAnythingIsTouched)
{
  const std::string inFile = this->path() + "/new";
  const std::string folder = fs::path(this->path()).parent_path().string();
  for (const auto& [path, reason] :
    { std::pair<std::string, std::string>{ "/nowhere/at/all", "No such file or directory" },
      { inFile, "Not a directory" }, { folder, "Is a directory" },
      { "/proc/nothing", "No such file or directory" } })
  {
    WholeFile file(path);
    const std::string error = file.open();
    EXPECT_THAT(error, HasSubstr("cannot write '" + path + "': "));
    EXPECT_THAT(error, HasSubstr(reason));
    if (path != "/proc/nothing") // the folder /proc appears to be writable
    {
      EXPECT_EQ(WholeFile::obstacle(path), error);
    }
  }
  EXPECT_EQ(WholeFile::obstacle(this->path()), "");
  EXPECT_EQ(WholeFile::obstacle(this->path() + ".other"), "");
  EXPECT_EQ(WholeFile::obstacle("here"), "") << "the folder it is in, which is the tests' own";
  EXPECT_FALSE(fs::exists(this->part()));
}
