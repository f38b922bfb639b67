// SPDX-License-Identifier: BSD-3-Clause
#include "Trials/TrialScore.h"

#include "Mechanics/Numerics/Constants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace trial_score
{
using palpate::Infinity;
using palpate::scoreTrials;
using palpate::TrialRecord;
using ::testing::HasSubstr;

namespace
{
/// Makes a record with `right` correct answers out of `trials`, between 1 N and 3 N; X is always
/// the stronger alternative.
TrialRecord answered(int right, int trials)
{
  TrialRecord record;
  record.head.alternatives = { { "soft", 1.0 }, { "hard", 3.0 } };
  record.head.hasRightAnswer = true;
  for (int i = 0; i < trials; ++i)
  {
    record.answers.push_back({ { 1, 0 }, i < right, 1.0, 0 });
  }
  return record;
}

/// Returns a standard normal number, which is the same with every library (Box and Muller).
double normalNumber(std::mt19937_64& random)
{
  const auto uniform = [&random] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  return radius * std::cos(2.0 * 3.14159265358979323846 * uniform());
}
} // namespace

TEST(TrialScore, CountsByPairs)
{
  TrialRecord record;
  record.head.alternatives = { { "a", 1.0 }, { "b", 2.0 }, { "c", 2.0 } };
  record.head.hasRightAnswer = true;
  record.answers = { { { 0, 1 }, true, 1.0, 0 }, { { 1, 0 }, true, 1.0, 0 },
    { { 1, 0 }, true, 1.0, 0 }, { { 2, 1 }, false, 1.0, 0 }, { { 1, 2 }, true, 1.0, 0 } };
  const auto score = scoreTrials(record);
  ASSERT_EQ(score.pairs.size(), 2U); // a and c were never compared
  EXPECT_EQ(score.pairs[0].first, 0);
  EXPECT_EQ(score.pairs[0].second, 1);
  EXPECT_EQ(score.pairs[0].firstChosen.successes, 1);
  EXPECT_EQ(score.pairs[0].firstChosen.trials, 3);
  EXPECT_TRUE(score.pairs[0].hasRightAnswer);
  EXPECT_EQ(score.pairs[0].correct.successes, 2);
  // A difference of 1 relative to the mean of 1.5.
  EXPECT_NEAR(score.pairs[0].difference, 2.0 / 3.0, 1e-15);
  EXPECT_EQ(score.pairs[1].firstChosen.successes, 2); // b was chosen, first as Y, then as X
  EXPECT_FALSE(score.pairs[1].hasRightAnswer);        // both alternatives are equal
  EXPECT_EQ(score.xChosen.successes, 4);
  EXPECT_EQ(score.xChosen.trials, 5);
  record.head.hasRightAnswer = false;
  EXPECT_FALSE(scoreTrials(record).pairs[0].hasRightAnswer);
}

TEST(TrialScore, JustNoticeableDifference)
{
  // At exactly the criterion, the difference of 2 N relative to a mean of 2 N is the
  // just-noticeable difference.
  const auto atCriterion = scoreTrials(answered(75, 100)).pairs[0];
  EXPECT_NEAR(atCriterion.difference, 1.0, 1e-15);
  EXPECT_NEAR(atCriterion.justNoticeable, 1.0, 1e-13);
  // d' = sqrt(2) z. 84.134 % correct is z = 1 (1 σ of the normal distribution). The criterion is at
  // 0.67449 σ; ± 0.67449 σ contains half of the distribution.
  const auto sure = scoreTrials(answered(8413, 10000)).pairs[0];
  EXPECT_NEAR(sure.justNoticeable, 0.67449, 2e-4); // 84.13 % instead of 84.134 %
  // The interval contains the value. Its bounds are in reverse order, because better answers mean a
  // smaller difference.
  EXPECT_LT(sure.justNoticeableLower, sure.justNoticeable);
  EXPECT_GT(sure.justNoticeableUpper, sure.justNoticeable);
  const auto all = scoreTrials(answered(10, 10)).pairs[0];
  EXPECT_EQ(all.justNoticeable, 0.0);
  EXPECT_EQ(all.justNoticeableLower, 0.0);
  // Lower bound for ten of ten correct: p = 0.025^(1/10) = 0.6915, z = 0.5001.
  EXPECT_NEAR(all.justNoticeableUpper, 0.67449 / 0.5001, 1e-3);
  const auto guessed = scoreTrials(answered(5, 10)).pairs[0];
  EXPECT_EQ(guessed.justNoticeable, Infinity);
  EXPECT_EQ(guessed.justNoticeableUpper, Infinity);
}

TEST(TrialScore, FindsTheThresholdOfASimulatedObserver)
{
  // Two impressions with noise of 0.5 N, as in the model. 75 % are correct at a difference of
  // sqrt(2) 0.5 Φ⁻¹(0.75) N, which is divided by the mean of 1.1 N.
  std::mt19937_64 random(5);
  TrialRecord record;
  record.head.alternatives = { { "soft", 0.9 }, { "hard", 1.3 } };
  record.head.hasRightAnswer = true;
  for (const palpate::Trial& trial : palpate::planTrials(2, 2000, 3))
  {
    const auto felt = [&](int i)
    {
      const double force = record.head.alternatives[static_cast<std::size_t>(i)].intensity;
      return force + 0.5 * normalNumber(random);
    };
    const double x = felt(trial.x);
    record.answers.push_back({ trial, x > felt(trial.y), 1.0, 1 });
  }
  const auto score = scoreTrials(record);
  const double threshold = std::sqrt(2.0) * 0.5 * 0.6744897502 / 1.1;
  EXPECT_LT(score.pairs[0].justNoticeableLower, threshold);
  EXPECT_GT(score.pairs[0].justNoticeableUpper, threshold);
  // With 4000 trials the share is accurate to 0.7 %, and its quantile to 3.5 %. The tolerance is
  // three times this.
  EXPECT_NEAR(score.pairs[0].justNoticeable, threshold, 0.11 * threshold);
  EXPECT_LT(score.xChosen.lower, 0.5);
  EXPECT_GT(score.xChosen.upper, 0.5);
}

TEST(TrialScore, SaysInWordsWhatItFound)
{
  const auto words = [](const TrialRecord& record)
  {
    std::string text;
    for (const std::string& line : describeScore(record.head, scoreTrials(record)))
    {
      text += line + "\n";
    }
    return text;
  };
  EXPECT_THAT(words(answered(10, 10)),
    HasSubstr("right in 10 of 10, 100 % (95 %: 69 to 100 %): distinguished\n"));
  EXPECT_THAT(words(answered(10, 10)), HasSubstr("soft against hard: soft chosen in 0 of 10"));
  EXPECT_THAT(words(answered(10, 10)), HasSubstr("they differ by 100 %"));
  EXPECT_THAT(words(answered(5, 10)), HasSubstr("not distinguished"));
  EXPECT_THAT(words(answered(5, 10)), HasSubstr("(75 % right): no limit"));
  EXPECT_THAT(words(answered(0, 10)), HasSubstr("in the wrong order"));
  TrialRecord chosen = answered(8, 10);
  chosen.head.hasRightAnswer = false;
  EXPECT_THAT(words(chosen), Not(HasSubstr("right in")));
  EXPECT_THAT(words(chosen), HasSubstr("X, the first of each two, chosen in 8 of 10"));
}
} // namespace trial_score
