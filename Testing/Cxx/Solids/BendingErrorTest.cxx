// SPDX-License-Identifier: BSD-3-Clause
// The stated fraction of a plate's bending that its elements miss, against elements of half the
// size; and the interpolation of this fraction between places. H is the regular part of the Green
// function (RegularGreen.h).
#include "Solids/TrueShape/BendingError.h"

#include "ShapedBodies.h"

namespace
{
using namespace palpate;

/// A plate of 10 by 10 mm, 2 mm thick, held at two ends, of quadratic tetrahedra with the given
/// side.
ElasticBodyInput plate(double side)
{
  const int along = static_cast<int>(10.0 / side + 0.5);
  const int through = static_cast<int>(2.0 / side + 0.5);
  return palpate::testing::heldAtTheEnds(
    palpate::testing::quadratic(
      palpate::testing::tetrahedra(palpate::testing::hexahedronBlock(along, along, through, side))),
    10.0);
}

/// H at a place on the plate, and the stated error of H.
struct Told
{
  double self = 0.0; ///< mm/N
  ExpectedError expected;

  explicit Told(double side, const Eigen::Vector3d& place)
  {
    const palpate::testing::ShapedBody solved(plate(side), place, 1.0);
    const std::int32_t point = palpate::testing::pointAt(solved.body.surface(), place);
    this->self = solved.green->at(point, point);
    this->expected = solved.green->elementError(point);
  }
};
} // namespace

TEST(BendingError, BoundsWhatTheElementsOfAPlateMiss)
{
  for (const Eigen::Vector3d& place :
    { Eigen::Vector3d(4.0, 4.0, 2.0), Eigen::Vector3d(4.0, 6.0, 2.0) })
  {
    const std::array<Told, 3> sides = { Told(2.0, place), Told(1.0, place), Told(0.5, place) };
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    {
      const Told& here = sides[i];
      const double bending = here.self - here.expected.direct;
      ASSERT_GT(bending, here.expected.direct);
      const double missed = 4.0 / 3.0 * (sides[i + 1].self - here.self) / bending;
      std::cout << "missed " << missed << ", told " << here.expected.bending << "\n";
      EXPECT_GT(here.expected.bending, missed);
      EXPECT_LT(here.expected.bending, 2.0 * missed);
    }
    EXPECT_LT(sides[1].expected.bending, sides[0].expected.bending);
  }
}

TEST(BendingError, IsCarriedByDistanceAndBending)
{
  const auto at = [](double x) { return Eigen::Vector3d(x, 0.0, 0.0); };
  EXPECT_EQ(BendingError({}).at(at(0.0)), BendingError::Assumed);
  // x is 4 % at the first sample and 2 % at the second.
  const BendingError both({ { at(0.0), 1.0, 0.01 }, { at(10.0), 2.0, 0.01 } });
  EXPECT_NEAR(both.at(at(0.0)), 0.04 / 0.96, 1e-12);
  EXPECT_NEAR(both.at(at(10.0)), 0.02 / 0.98, 1e-12);
  EXPECT_NEAR(both.at(at(5.0)), 0.08 / (3.0 - 0.08), 1e-12);
  EXPECT_EQ(BendingError({ { at(0.0), 1.0, 0.0 } }).at(at(1.0)), BendingError::Least);
  EXPECT_EQ(BendingError({ { at(0.0), 1.0, 10.0 } }).at(at(1.0)), BendingError::Most);
}

// Every fourth sample has an energy that is a hundred times that of bending, from the field of the
// source itself. Such a sample must have no effect, not even at its own place.
TEST(BendingError, LeavesOutWhatIsNoBending)
{
  std::vector<BendingError::Sample> samples;
  for (int i = 0; i < 20; ++i)
  {
    samples.push_back({ Eigen::Vector3d(i, 0.0, 0.0), 2.0, i % 4 == 1 ? 1.0 : 0.01 });
  }
  const BendingError bending(samples);
  for (const double x : { 0.0, 1.0, 7.3, 19.0 })
  {
    EXPECT_NEAR(bending.at(Eigen::Vector3d(x, 0.0, 0.0)), 0.02 / 0.98, 1e-12) << x;
  }
}
