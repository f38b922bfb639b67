// SPDX-License-Identifier: BSD-3-Clause
// A body is unchanged after it is written to a file and read. A file that is incomplete or has
// another format is rejected with a reason.
#include "Contact/FlatBodyFile.h"

#include "FileSizeLimit.h"
#include "FlatBodyFixture.h"
#include "Contact/ToolContact.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
class FlatBodyFileTest : public FlatBodyFixture
{
protected:
  FlatBodyFileTest()
    : FlatBodyFixture(3)
  {
  }
};
} // namespace

TEST_F(FlatBodyFileTest, TheBodyComesBackToTheBit)
{
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->flat()), "");
  FlatBodyFile file;
  ASSERT_EQ(file.open(this->Path), "");
  const FlatBody& read = file.body();
  const FlatBody wrote = this->flat();
  ASSERT_EQ(read.points, wrote.points);
  ASSERT_EQ(read.triangles, wrote.triangles);
  EXPECT_EQ(read.tool, wrote.tool);
  EXPECT_EQ(read.model, wrote.model);
  EXPECT_EQ(read.modelParts, wrote.modelParts);
  EXPECT_EQ(read.response.samples, wrote.response.samples);
  EXPECT_EQ(read.response.exponent, wrote.response.exponent);
  const auto same = [](const void* a, const void* b, std::size_t size)
  { return std::memcmp(a, b, size) == 0; };
  EXPECT_TRUE(same(read.coordinates, wrote.coordinates, 24 * wrote.points));
  EXPECT_TRUE(same(read.corners, wrote.corners, 12 * wrote.triangles));
  EXPECT_TRUE(same(read.response.force, wrote.response.force, 32 * wrote.points));
  EXPECT_TRUE(same(read.response.stiffness, wrote.response.stiffness, 32 * wrote.points));
  EXPECT_TRUE(same(read.response.normal, wrote.response.normal, 12 * wrote.points));
  EXPECT_TRUE(same(read.response.range, wrote.response.range, 4 * wrote.points));
  EXPECT_TRUE(same(read.response.status, wrote.response.status, wrote.points));
  EXPECT_TRUE(same(read.validity, wrote.validity, 4 * wrote.points));
  EXPECT_TRUE(same(read.limit, wrote.limit, wrote.points));

  const auto direct = contactBody(this->Ball, this->Store);
  const auto loaded = makeContactBody(read);
  ToolContact a(*direct);
  ToolContact b(*loaded);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-20.0, 20.0);
  for (int i = 0; i < 500; ++i)
  {
    const Vector3 tip(anywhere(random), anywhere(random), anywhere(random));
    const Contact first = a.update(tip);
    const Contact second = b.update(tip);
    EXPECT_EQ(first.state, second.state);
    EXPECT_EQ(first.force, second.force);
  }
}

TEST_F(FlatBodyFileTest, TheCompactFormComesBackToTheBit)
{
  FlatBody body = this->flat();
  std::vector<float> basis(32);
  for (std::size_t i = 0; i < basis.size(); ++i)
  {
    basis[i] = 0.25F * static_cast<float>(i + 1);
  }
  std::vector<float> coefficient(2 * body.points, 0.5F);
  body.response.force = nullptr;
  body.response.stiffness = nullptr;
  body.response.laws = 2;
  body.response.basis = basis.data();
  body.response.coefficient = coefficient.data();
  ASSERT_EQ(FlatBodyFile::write(this->Path, body), "");
  FlatBodyFile file;
  ASSERT_EQ(file.open(this->Path), "");
  EXPECT_EQ(file.body().response.force, nullptr);
  ASSERT_EQ(file.body().response.laws, 2);
  EXPECT_EQ(std::memcmp(file.body().response.basis, basis.data(), 32 * 4), 0);
  EXPECT_EQ(ResponseField(file.body().response).evaluate(0, 0.7).force,
    ResponseField(body.response).evaluate(0, 0.7).force);
}

// A file in the first format, which had no model parts.
TEST_F(FlatBodyFileTest, AFileOfTheFirstFormatIsRead)
{
  FlatBodyFile file;
  ASSERT_EQ(file.open(PALPATE_DATA_DIR "/Determinism/body.palpate"), "");
  EXPECT_EQ(file.body().model, "half-space");
  EXPECT_EQ(file.body().modelParts, HalfSpacePart);
}

TEST_F(FlatBodyFileTest, ATruncatedFileIsRefusedWhereverItIsCut)
{
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->flat()), "");
  const std::vector<char> whole = this->bytes();
  for (const double share : { 0.0, 0.001, 0.1, 0.5, 0.999 })
  {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    this->replace({ whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size) });
    const std::string error = this->openError();
    EXPECT_TRUE(contains(error, this->Path)) << error;
    EXPECT_TRUE(contains(error, "truncated") || contains(error, "too short")) << error;
  }
}

TEST_F(FlatBodyFileTest, AForeignFileIsRefused)
{
  this->replace(std::vector<char>(100000, 'x'));
  EXPECT_TRUE(contains(this->openError(), "not a Palpate body file"));
  std::remove(this->Path.c_str());
  EXPECT_TRUE(contains(this->openError(), "No such file"));
  FlatBodyFile file;
  EXPECT_TRUE(contains(file.open(::testing::TempDir()), "not a file"));
}

TEST_F(FlatBodyFileTest, ANewerFormatAndTheOtherByteOrderAreNamed)
{
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->flat()), "");
  const std::vector<char> whole = this->bytes();
  std::vector<char> newer = whole;
  newer[8] = static_cast<char>(FlatBodyFile::Version + 1);
  this->replace(newer);
  EXPECT_TRUE(contains(this->openError(), "newer than this program"));
  std::vector<char> swapped = whole;
  std::swap(swapped[12], swapped[15]);
  std::swap(swapped[13], swapped[14]);
  this->replace(swapped);
  EXPECT_TRUE(contains(this->openError(), "other byte order"));
}

TEST_F(FlatBodyFileTest, AnyDamagedByteIsFound)
{
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->flat()), "");
  const std::vector<char> whole = this->bytes();
  std::mt19937 random(11);
  // Damages a byte after the header (coordinates and forces), but not in the padding between
  // arrays, which is not read; then a byte of the header before the offsets.
  std::uniform_int_distribution<std::size_t> content(448, 448 + 24 * this->Ball.points.size() - 1);
  std::uniform_int_distribution<std::size_t> head(0, 63);
  for (int i = 0; i < 200; ++i)
  {
    std::vector<char> damaged = whole;
    damaged[i % 2 == 0 ? content(random) : head(random)] ^= 0x10;
    this->replace(damaged);
    EXPECT_NE(this->openError(), "");
  }
  this->replace(whole);
  EXPECT_EQ(this->openError(), "");
}

TEST_F(FlatBodyFileTest, AFileThatCannotBeWrittenLeavesTheOldOne)
{
  const std::string nowhere = this->Path + "/no/such/folder.palpate";
  EXPECT_TRUE(contains(FlatBodyFile::write(nowhere, this->flat()), nowhere));
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->flat()), "");
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->flat()), "") << "an old file is replaced";
  EXPECT_EQ(this->openError(), "");
  std::string error;
  {
    const FileSizeLimit full(10000); // in the middle of the coordinates
    error = FlatBodyFile::write(this->Path, this->flat());
  }
  EXPECT_EQ(error, "cannot write '" + this->Path + "': File too large");
  EXPECT_EQ(this->openError(), "");
  EXPECT_FALSE(std::ifstream(this->Path + ".part").good());
}
