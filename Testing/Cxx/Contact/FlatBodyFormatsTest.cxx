// SPDX-License-Identifier: BSD-3-Clause
// Relaxation and tilts in a body file, and older formats, which have a shorter header.
#include "Contact/FlatBodyFile.h"

#include "FlatBodyFixture.h"
#include "SampleTilts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

using namespace palpate;
using namespace palpate::testing;

namespace
{
constexpr std::size_t ChecksumAt = 24; // offsets of the numbers in the header, see FlatBodyHeader.h
constexpr std::size_t EdgesAt = 416;
constexpr std::size_t BranchesAt = 456;
constexpr std::size_t TimesAt = 496;
constexpr std::size_t ContactAt = 528;
constexpr std::size_t LaterOffsetsAt = 544;
constexpr std::size_t CouplingAt = 560;
constexpr std::size_t CouplingOffsetsAt = 632;
constexpr std::size_t HeaderSize = 688;

class FlatBodyFormatsTest : public FlatBodyFixture
{
protected:
  FlatBodyFormatsTest()
    : FlatBodyFixture(2)
    , Strength(2 * this->Ball.points.size())
    , Elastic(this->Ball.points.size(), 0.25F)
  {
    for (std::size_t i = 0; i < this->Strength.size(); ++i)
    {
      this->Strength[i] = 0.125F * static_cast<float>(i);
    }
  }

  FlatBody relaxing() const
  {
    FlatBody body = this->flat();
    RelaxationTerms& terms = body.response.relaxation;
    terms.series.add(0.1, 0.3);
    terms.series.add(0.7, 5.0);
    terms.strength = this->Strength.data();
    terms.elasticCompliance = this->Elastic.data();
    terms.exponent = 1.4;
    terms.radius = 2.5;
    return body;
  }

  /// Writes the checksum (FNV-1a over words) for this header and these sections.
  void mend(
    std::vector<char>& file, std::size_t header, std::size_t branches, bool isCoupled = false) const
  {
    const std::size_t n = this->Ball.points.size();
    const std::size_t sizes[] = { 24 * n, 12 * this->Ball.triangles.size(), 32 * n, 32 * n, 0, 0,
      12 * n, 4 * n, n, 4 * n, n, 4 * n * branches, branches > 0 ? 4 * n : 0,
      isCoupled ? std::size_t{ 79 * 24 } : 0, isCoupled ? 4 * n : 0, isCoupled ? 4 * n : 0,
      isCoupled ? 8 * n : 0 };
    std::memset(file.data() + ChecksumAt, 0, 8);
    std::uint64_t sum = 0xcbf29ce484222325ULL;
    const auto mix = [&sum](std::uint64_t word)
    {
      sum = (sum ^ word) * 0x100000001b3ULL;
      sum ^= sum >> 32;
    };
    const auto add = [&](std::size_t begin, std::size_t count)
    {
      std::size_t i = 0;
      for (; i + 8 <= count; i += 8)
      {
        mix(this->wordAt(file, begin + i));
      }
      for (; i < count; ++i)
      {
        mix(static_cast<unsigned char>(file[begin + i]));
      }
    };
    add(0, header);
    for (std::size_t k = 0; k < 17; ++k)
    {
      if (sizes[k] > 0)
      {
        const std::size_t place = k < 11 ? 64 + 8 * k
          : k < 13                       ? LaterOffsetsAt + 8 * (k - 11)
                                         : CouplingOffsetsAt + 8 * (k - 13);
        add(this->wordAt(file, place), sizes[k]);
      }
    }
    std::memcpy(file.data() + ChecksumAt, &sum, sizeof sum);
  }
  static std::uint64_t wordAt(const std::vector<char>& file, std::size_t place)
  {
    std::uint64_t word = 0;
    std::memcpy(&word, file.data() + place, sizeof word);
    return word;
  }

  /// Error message for a file in which one number is changed, in the header or elsewhere.
  template <class Number>
  std::string errorWith(std::size_t place, Number number) const
  {
    EXPECT_EQ(FlatBodyFile::write(this->Path, this->relaxing()), "");
    std::vector<char> file = this->bytes();
    std::memcpy(file.data() + place, &number, sizeof number);
    this->mend(file, HeaderSize, 2);
    this->replace(file);
    return this->openError();
  }

  std::vector<float> Strength;
  std::vector<float> Elastic;
};

/// Coupling on a layer, with all arrays that may vary from point to point.
struct Coupled
{
  explicit Coupled(std::size_t points)
    : knots(CouplingLaw::KnotCount)
  {
    for (std::size_t k = 0; k < this->knots.size(); ++k)
    {
      const auto number = static_cast<double>(k);
      this->knots[k] = { 1.0 / (1.0 + number), -0.1 * number, 0.3 * number };
    }
    for (std::size_t i = 0; i < points; ++i)
    {
      const auto number = static_cast<float>(i);
      this->modulus.push_back(0.1F + 0.01F * number);
      this->thickness.push_back(5.0F + 0.1F * number);
      this->modes.insert(this->modes.end(), { 0.5F * number, -0.25F * number });
    }
  }

  CouplingTerms terms() const
  {
    CouplingTerms terms;
    terms.modulus = 0.7;
    terms.thickness = 4.5;
    terms.knots = this->knots.data();
    terms.localModulus = this->modulus.data();
    terms.localThickness = this->thickness.data();
    terms.modes = this->modes.data();
    terms.modeCount = 2;
    return terms;
  }

  std::vector<CouplingKnot> knots;
  std::vector<float> modulus;
  std::vector<float> thickness;
  std::vector<float> modes;
};
} // namespace

TEST_F(FlatBodyFormatsTest, RelaxationComesBackToTheBit)
{
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->relaxing()), "");
  FlatBodyFile file;
  ASSERT_EQ(file.open(this->Path), "");
  const RelaxationTerms& read = file.body().response.relaxation;
  ASSERT_EQ(read.series.count, 2U);
  EXPECT_EQ(read.series.strength[0], 0.1);
  EXPECT_EQ(read.series.strength[1], 0.7);
  EXPECT_EQ(read.series.time[0], 0.3);
  EXPECT_EQ(read.series.time[1], 5.0);
  EXPECT_EQ(read.exponent, 1.4);
  EXPECT_EQ(read.radius, 2.5);
  ASSERT_NE(read.strength, nullptr);
  ASSERT_NE(read.elasticCompliance, nullptr);
  EXPECT_EQ(std::memcmp(read.strength, this->Strength.data(), 4 * this->Strength.size()), 0);
  EXPECT_EQ(std::memcmp(read.elasticCompliance, this->Elastic.data(), 4 * this->Elastic.size()), 0);
}

TEST_F(FlatBodyFormatsTest, WithoutRelaxationThereIsNone)
{
  ASSERT_EQ(FlatBodyFile::write(this->Path, this->flat()), "");
  FlatBodyFile file;
  ASSERT_EQ(file.open(this->Path), "");
  const RelaxationTerms& read = file.body().response.relaxation;
  EXPECT_EQ(read.series.count, 0U);
  EXPECT_EQ(read.strength, nullptr);
  EXPECT_EQ(read.elasticCompliance, nullptr);
  EXPECT_FALSE(read.areFelt());
}

// An older file has a shorter header, and other data follow at the place of the new numbers. These
// data must not be read as numbers of the header.
TEST_F(FlatBodyFormatsTest, FormatsOfBeforeAreRead)
{
  FlatBody body = this->flat();
  body.response.edges = { 1.5, 2.0, 0.4, 6.0, true };
  ASSERT_EQ(FlatBodyFile::write(this->Path, body), "");
  const std::vector<char> whole = this->bytes();
  const std::size_t sizes[] = { 408, 416, 456, 560 };
  for (std::uint32_t version = 1; version <= 4; ++version)
  {
    std::vector<char> file = whole;
    const std::size_t size = sizes[version - 1];
    std::memcpy(file.data() + 8, &version, sizeof version);
    std::memset(file.data() + size, 0xff, HeaderSize - size);
    this->mend(file, size, 0);
    this->replace(file);
    FlatBodyFile read;
    ASSERT_EQ(read.open(this->Path), "") << version;
    EXPECT_EQ(read.body().points, body.points);
    EXPECT_EQ(read.body().response.edges.areFelt(), version >= 3);
    EXPECT_EQ(read.body().response.edges.extent, version >= 3 ? 6.0 : 0.0);
    EXPECT_FALSE(read.body().response.coupling.areFelt());
    EXPECT_EQ(read.body().response.relaxation.series.count, 0U);
    EXPECT_EQ(read.body().response.relaxation.elasticCompliance, nullptr);
    EXPECT_FALSE(read.body().response.tilt.areFelt());
    EXPECT_EQ(std::memcmp(read.body().response.force, body.response.force, 32 * body.points), 0);
  }
}

TEST_F(FlatBodyFormatsTest, WrongRelaxationIsRefused)
{
  EXPECT_EQ(this->errorWith(TimesAt, 4.0), "");
  for (const std::int32_t count : { -1, 5, 1 << 30 })
  {
    EXPECT_TRUE(contains(this->errorWith(BranchesAt, count), "damaged header")) << count;
  }
  EXPECT_TRUE(contains(this->errorWith(BranchesAt + 4, std::int32_t{ 4 }), "damaged header"));
  EXPECT_TRUE(contains(this->errorWith(BranchesAt + 8, -0.5), "damaged header"));
  EXPECT_TRUE(contains(this->errorWith(BranchesAt + 8, std::nan("")), "damaged header"));
  EXPECT_TRUE(contains(this->errorWith(TimesAt + 8, 0.0), "damaged header"));
  EXPECT_TRUE(contains(this->errorWith(ContactAt, 0.0), "damaged header"));
  EXPECT_TRUE(contains(this->errorWith(ContactAt + 8, -1.0), "damaged header"));
  const std::vector<char> file = this->bytes();
  const std::size_t strengths = this->wordAt(file, LaterOffsetsAt);
  const std::size_t elastic = this->wordAt(file, LaterOffsetsAt + 8);
  EXPECT_TRUE(contains(
    this->errorWith(strengths + 4 * (2 * 7 + 1), -0.5F), "a relaxation of -0.5 at point 7"));
  EXPECT_TRUE(
    contains(this->errorWith(strengths, std::nanf("")), "a relaxation of nan at point 0"));
  EXPECT_TRUE(
    contains(this->errorWith(elastic + 4 * 9, -1.0F), "an elastic compliance of -1 at point 9"));
  EXPECT_TRUE(contains(this->errorWith(EdgesAt, -1.0), "damaged header"));
}

TEST_F(FlatBodyFormatsTest, CouplingComesBackToTheBit)
{
  const Coupled coupled(this->Ball.points.size());
  FlatBody body = this->flat();
  body.response.coupling = coupled.terms();
  ASSERT_EQ(FlatBodyFile::write(this->Path, body), "");
  FlatBodyFile file;
  ASSERT_EQ(file.open(this->Path), "");
  const CouplingTerms& read = file.body().response.coupling;
  EXPECT_EQ(read.modulus, 0.7);
  EXPECT_EQ(read.thickness, 4.5);
  EXPECT_EQ(read.modeCount, 2);
  EXPECT_EQ(std::memcmp(read.knots, coupled.knots.data(), 79 * sizeof(CouplingKnot)), 0);
  const std::size_t bytes = 4 * body.points;
  EXPECT_EQ(std::memcmp(read.localModulus, coupled.modulus.data(), bytes), 0);
  EXPECT_EQ(std::memcmp(read.localThickness, coupled.thickness.data(), bytes), 0);
  EXPECT_EQ(std::memcmp(read.modes, coupled.modes.data(), 2 * bytes), 0);
  EXPECT_NE(makeContactBody(file.body())->coupling, nullptr);

  body.response.coupling = {};
  body.response.coupling.modulus = 0.25; // coupling on a half-space, which has no arrays
  ASSERT_EQ(FlatBodyFile::write(this->Path, body), "");
  ASSERT_EQ(file.open(this->Path), "");
  EXPECT_EQ(file.body().response.coupling.modulus, 0.25);
  EXPECT_EQ(file.body().response.coupling.knots, nullptr);
  EXPECT_EQ(file.body().response.coupling.modes, nullptr);
  body.response.coupling = {};
  ASSERT_EQ(FlatBodyFile::write(this->Path, body), "");
  ASSERT_EQ(file.open(this->Path), "");
  EXPECT_EQ(makeContactBody(file.body())->coupling, nullptr);
}

TEST_F(FlatBodyFormatsTest, WrongCouplingIsRefused)
{
  const Coupled coupled(this->Ball.points.size());
  FlatBody body = this->flat();
  body.response.coupling = coupled.terms();
  const auto errorWith = [&](std::size_t place, auto number)
  {
    EXPECT_EQ(FlatBodyFile::write(this->Path, body), "");
    std::vector<char> file = this->bytes();
    std::memcpy(file.data() + place, &number, sizeof number);
    this->mend(file, HeaderSize, 0, true);
    this->replace(file);
    return this->openError();
  };
  EXPECT_EQ(errorWith(CouplingAt + 8, 0.9), "");
  for (const std::int32_t parts : { -1, 8, 1 << 30 })
  {
    EXPECT_TRUE(contains(errorWith(CouplingAt, parts), "damaged header")) << parts;
  }
  EXPECT_TRUE(contains(errorWith(CouplingAt + 4, std::int32_t{ 17 }), "damaged header"));
  EXPECT_TRUE(contains(errorWith(CouplingAt + 8, std::nan("")), "damaged header"));
  EXPECT_TRUE(contains(errorWith(CouplingAt + 16, -1.0), "damaged header"));
  EXPECT_TRUE(contains(errorWith(CouplingAt + 16, 0.0), "couples wrongly: the thickness"));
  const std::vector<char> file = this->bytes();
  const auto section = [&](std::size_t k) { return this->wordAt(file, CouplingOffsetsAt + 8 * k); };
  EXPECT_TRUE(contains(errorWith(section(0) + 24 * 3, std::nan("")), "knot 3 must be finite"));
  EXPECT_TRUE(contains(errorWith(section(1) + 4 * 9, 0.0F), "modulus (MPa) of point 9"));
  EXPECT_TRUE(contains(errorWith(section(2) + 4 * 5, -1.0F), "thickness (mm) of point 5"));
  EXPECT_TRUE(contains(errorWith(section(3) + 4 * 7, std::nanf("")), "mode 1 of point 3"));
}

namespace
{
/// Tilt laws: two laws and their weights at each point.
struct Tilts
{
  explicit Tilts(std::size_t points)
  {
    for (std::size_t i = 0; i < points; ++i)
    {
      this->weight.push_back(0.25F);
      this->weight.push_back(0.75F);
    }
    this->store.views.weight = this->weight.data();
  }
  TiltStore store{ { noFactor, [](double depth, double angle) { return 1.0 + depth * angle; } },
    dropOfSphere(5.0), 2.0, 0.5 };
  std::vector<float> weight;
};
} // namespace

TEST_F(FlatBodyFormatsTest, TiltsComeBackToTheBit)
{
  const Tilts tilts(this->Ball.points.size());
  FlatBody body = this->relaxing();
  body.response.tilt = tilts.store.views;
  ASSERT_EQ(FlatBodyFile::write(this->Path, body), "");
  FlatBodyFile file;
  ASSERT_EQ(file.open(this->Path), "");
  const TiltViews& read = file.body().response.tilt;
  EXPECT_EQ(read.terms.range, 2.0);
  EXPECT_EQ(read.terms.largest, 0.5);
  EXPECT_EQ(read.terms.dropScale, 0.0);
  ASSERT_EQ(read.terms.laws, 2);
  ASSERT_EQ(TiltTable::nodeCount(read.terms), tilts.store.nodes.size());
  ASSERT_EQ(TiltTable::dropCount(read.terms), tilts.store.drops.size());
  EXPECT_TRUE(std::equal(tilts.store.drops.begin(), tilts.store.drops.end(), read.drops));
  EXPECT_TRUE(std::equal(tilts.store.nodes.begin(), tilts.store.nodes.end(), read.nodes));
  EXPECT_TRUE(std::equal(tilts.weight.begin(), tilts.weight.end(), read.weight));
  EXPECT_EQ(file.body().response.relaxation.series.count, 2U);
}

TEST_F(FlatBodyFormatsTest, WrongTiltsAreRefused)
{
  const auto errorOf = [this](Tilts& tilts)
  {
    FlatBody body = this->flat();
    body.response.tilt = tilts.store.views;
    EXPECT_EQ(FlatBodyFile::write(this->Path, body), "");
    return this->openError();
  };
  const std::size_t points = this->Ball.points.size();
  Tilts sum(points);
  sum.weight[2 * 7] = 0.5F;
  EXPECT_TRUE(contains(errorOf(sum), "tilts at point 7 must have the sum 1, but have 1.25"));
  Tilts node(points);
  node.store.nodes[5] = std::nan("");
  EXPECT_TRUE(contains(errorOf(node), "value 5 of the nodes is not finite"));
  Tilts drop(points);
  drop.store.drops[3] = INFINITY;
  EXPECT_TRUE(contains(errorOf(drop), "value 3 of the drops is not finite"));
  Tilts lone(points);
  lone.store.views.weight = nullptr;
  EXPECT_TRUE(contains(errorOf(lone), "damaged header"));
  Tilts far(points);
  far.store.views.terms.largest = 1.7;
  EXPECT_TRUE(contains(errorOf(far), "damaged header"));
}
