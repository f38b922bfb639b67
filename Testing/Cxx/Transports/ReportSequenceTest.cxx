// SPDX-License-Identifier: BSD-3-Clause
// Decides which reports are new: gaps, old reports, wrap-around of the number, a device that
// restarts.
#include "Transports/Hid/ReportSequence.h"

#include <gtest/gtest.h>

using palpate::ReportSequence;
using Verdict = palpate::ReportSequence::Verdict;

TEST(ReportSequence, CountsWhatIsLost)
{
  ReportSequence sequence;
  EXPECT_EQ(sequence.judge(100), Verdict::New);
  EXPECT_EQ(sequence.judge(101), Verdict::New);
  EXPECT_EQ(sequence.judge(105), Verdict::New);
  EXPECT_EQ(sequence.lost(), 3U);
  EXPECT_EQ(sequence.stale(), 0U);
  EXPECT_EQ(sequence.newest(), 105U);
}

TEST(ReportSequence, OldAndRepeatedAreStale)
{
  ReportSequence sequence;
  sequence.judge(100);
  EXPECT_EQ(sequence.judge(100), Verdict::Stale);
  EXPECT_EQ(sequence.judge(99), Verdict::Stale);
  EXPECT_EQ(sequence.judge(101), Verdict::New);
  for (int i = 0; i < 1000; ++i) // a device that hangs repeats its report
  {
    ASSERT_EQ(sequence.judge(101), Verdict::Stale);
  }
  EXPECT_EQ(sequence.stale(), 1002U);
  EXPECT_EQ(sequence.lost(), 0U);
}

TEST(ReportSequence, WrapsAround)
{
  ReportSequence sequence;
  sequence.judge(0xFFFFFFFE);
  EXPECT_EQ(sequence.judge(0xFFFFFFFF), Verdict::New);
  EXPECT_EQ(sequence.judge(0), Verdict::New);
  EXPECT_EQ(sequence.judge(2), Verdict::New);
  EXPECT_EQ(sequence.judge(0xFFFFFFFF), Verdict::Stale);
  EXPECT_EQ(sequence.lost(), 1U);
}

TEST(ReportSequence, ADeviceThatStartsAnewIsBelievedAfterAWhile)
{
  for (const std::uint32_t last : { 1000U, 0xFFFF0000U, 0x80000000U })
  {
    ReportSequence sequence;
    sequence.judge(last);
    for (std::uint32_t i = 1; i < ReportSequence::Confirmations; ++i)
    {
      ASSERT_EQ(sequence.judge(i), Verdict::Stale) << last;
    }
    EXPECT_EQ(sequence.judge(ReportSequence::Confirmations), Verdict::Restarted) << last;
    EXPECT_EQ(sequence.judge(ReportSequence::Confirmations + 1), Verdict::New);
    EXPECT_EQ(sequence.lost(), 0U) << "a new start is no gap";
  }
}

TEST(ReportSequence, StraysDoNotMakeANewStart)
{
  ReportSequence sequence;
  sequence.judge(50000);
  for (std::uint32_t i = 1; i <= 100; ++i)
  {
    ASSERT_EQ(sequence.judge(i), Verdict::Stale) << "an old one";
    ASSERT_EQ(sequence.judge(50000 + i), Verdict::New) << "between those that follow";
  }
  ASSERT_EQ(sequence.judge(900000), Verdict::Stale) << "far ahead, once";
  EXPECT_EQ(sequence.judge(50101), Verdict::New);
  EXPECT_EQ(sequence.lost(), 0U);
}

TEST(ReportSequence, TheLargestGapIsStillOne)
{
  ReportSequence sequence;
  sequence.judge(0);
  EXPECT_EQ(sequence.judge(ReportSequence::LargestGap), Verdict::New);
  EXPECT_EQ(sequence.judge(2 * ReportSequence::LargestGap + 1), Verdict::Stale);
}

TEST(ReportSequence, ANewConnectionBeginsWithAnyNumber)
{
  ReportSequence sequence;
  sequence.judge(1000);
  sequence.restart();
  EXPECT_EQ(sequence.judge(3), Verdict::New);
  EXPECT_EQ(sequence.judge(4), Verdict::New);
}
