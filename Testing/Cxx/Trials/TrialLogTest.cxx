// SPDX-License-Identifier: BSD-3-Clause
#include "Trials/TrialLog.h"

#include "FileSizeLimit.h"
#include "ScratchFile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace trial_log
{
using palpate::readTrialLog;
using palpate::TrialAnswer;
using palpate::TrialHead;
using palpate::TrialLog;
using palpate::TrialRecord;
using palpate::testing::ScratchFile;
using ::testing::HasSubstr;

namespace
{
TrialHead sampleHead()
{
  TrialHead head;
  head.alternatives = { { "blunted:1,30", 0.1 }, { "friction=0.3", 2.5 } };
  head.question = "Which one pushes back more?";
  head.hasRightAnswer = true;
  head.seed = 18446744073709551615U;
  head.forceFactor = 0.12;
  head.device = "simulated, \"stiff\" hand";
  head.started = "2002-03-24 09:00:00";
  return head;
}

const std::vector<TrialAnswer> Answers = { { { 0, 1 }, true, 1.0 / 3.0, 0 },
  { { 1, 0 }, true, 12.5, 7 }, { { 0, 1 }, false, 0.0, 1 } };

std::string contentOf(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void writeSample(const std::string& path)
{
  TrialLog log;
  ASSERT_EQ(log.open(path, sampleHead()), "");
  for (const TrialAnswer& answer : Answers)
  {
    ASSERT_EQ(log.append(answer), "");
  }
}
} // namespace

TEST(TrialLog, IsWhatItsHeaderShows)
{
  const ScratchFile file(".csv");
  writeSample(file.path());
  EXPECT_EQ(contentOf(file.path()),
    "# palpate trial 1\n"
    "# question: Which one pushes back more?\n"
    "# right answer: the larger intensity\n"
    "# alternative A: blunted:1,30\n"
    "# intensity A: 0.1\n"
    "# alternative B: friction=0.3\n"
    "# intensity B: 2.5\n"
    "# seed: 18446744073709551615\n"
    "# force factor: 0.12\n"
    "# device: simulated, \"stiff\" hand\n"
    "# started: 2002-03-24 09:00:00\n"
    "trial,x,y,answer,chosen,correct,seconds,switches\n"
    "1,A,B,X,A,0,0.3333333333333333,0\n"
    "2,B,A,X,B,1,12.5,7\n"
    "3,A,B,Y,B,1,0,1\n");
}

TEST(TrialLog, ReadsBack)
{
  const ScratchFile file(".csv");
  writeSample(file.path());
  TrialRecord record;
  ASSERT_EQ(readTrialLog(file.path(), record), "");
  const TrialHead head = sampleHead();
  ASSERT_EQ(record.head.alternatives.size(), 2U);
  EXPECT_EQ(record.head.alternatives[1].name, head.alternatives[1].name);
  EXPECT_EQ(record.head.alternatives[1].intensity, head.alternatives[1].intensity);
  EXPECT_EQ(record.head.question, head.question);
  EXPECT_TRUE(record.head.hasRightAnswer);
  EXPECT_EQ(record.head.seed, head.seed);
  EXPECT_EQ(record.head.forceFactor, head.forceFactor);
  EXPECT_EQ(record.head.device, head.device);
  EXPECT_EQ(record.head.started, head.started);
  ASSERT_EQ(record.answers.size(), Answers.size());
  for (std::size_t i = 0; i < Answers.size(); ++i)
  {
    EXPECT_EQ(record.answers[i].trial.x, Answers[i].trial.x);
    EXPECT_EQ(record.answers[i].trial.y, Answers[i].trial.y);
    EXPECT_EQ(record.answers[i].choseX, Answers[i].choseX);
    EXPECT_EQ(record.answers[i].seconds, Answers[i].seconds);
    EXPECT_EQ(record.answers[i].switches, Answers[i].switches);
  }
}

TEST(TrialLog, KeepsEachAnswerAtOnce)
{
  // The log is read while it is still open, as after an interrupted session.
  const ScratchFile file(".csv");
  TrialLog log;
  ASSERT_EQ(log.open(file.path(), sampleHead()), "");
  for (std::size_t i = 0; i <= Answers.size(); ++i)
  {
    TrialRecord record;
    ASSERT_EQ(readTrialLog(file.path(), record), "");
    EXPECT_EQ(record.answers.size(), i);
    if (i < Answers.size())
    {
      ASSERT_EQ(log.append(Answers[i]), "");
    }
  }
}

TEST(TrialLog, NoAnswerIsRightAmongEquals)
{
  TrialHead head = sampleHead();
  EXPECT_EQ(isRight(head, Answers[0]), 0);
  EXPECT_EQ(isRight(head, Answers[1]), 1);
  head.hasRightAnswer = false;
  EXPECT_EQ(isRight(head, Answers[1]), -1);
  head.hasRightAnswer = true;
  head.alternatives[0].intensity = head.alternatives[1].intensity;
  EXPECT_EQ(isRight(head, Answers[1]), -1);
  const ScratchFile file(".csv");
  TrialLog log;
  ASSERT_EQ(log.open(file.path(), head), "");
  ASSERT_EQ(log.append(Answers[1]), "");
  EXPECT_THAT(contentOf(file.path()), HasSubstr("\n1,B,A,X,B,,12.5,7\n"));
  TrialRecord record;
  EXPECT_EQ(readTrialLog(file.path(), record), "");
}

TEST(TrialLog, OnAFullDiskTheAnswersBeforeStayReadable)
{
  const ScratchFile file(".csv");
  TrialLog log;
  ASSERT_EQ(log.open(file.path(), sampleHead()), "");
  ASSERT_EQ(log.append(Answers[0]), "");
  const std::string before = contentOf(file.path());
  std::string error;
  {
    const palpate::testing::FileSizeLimit full(before.size() + 5); // space for a part of a row
    error = log.append(Answers[1]);
  }
  EXPECT_EQ(error, "cannot write the trial log '" + file.path() + "': File too large");
  EXPECT_EQ(contentOf(file.path()), before);
  // There is space again, but appending to a log with a gap would number its answers wrongly.
  EXPECT_THAT(log.append(Answers[2]), HasSubstr(file.path()));
  TrialRecord record;
  ASSERT_EQ(readTrialLog(file.path(), record), "");
  EXPECT_EQ(record.answers.size(), 1U);
}

TEST(TrialLog, OnAFullDiskNoHalfOfAHeadIsInTheWay)
{
  const ScratchFile file(".csv");
  TrialLog log;
  {
    const palpate::testing::FileSizeLimit full(20);
    EXPECT_THAT(log.open(file.path(), sampleHead()), HasSubstr("File too large"));
  }
  EXPECT_FALSE(std::ifstream(file.path()).good());
  EXPECT_EQ(log.open(file.path(), sampleHead()), "");
  EXPECT_THAT(TrialLog().open("/nowhere/log.csv", sampleHead()),
    HasSubstr("'/nowhere/log.csv': No such file or directory"));
}

TEST(TrialLog, OverwritesNothing)
{
  const ScratchFile file(".csv");
  writeSample(file.path());
  const std::string before = contentOf(file.path());
  TrialLog log;
  EXPECT_THAT(log.open(file.path(), sampleHead()), HasSubstr(file.path()));
  EXPECT_EQ(contentOf(file.path()), before);
}

TEST(TrialLog, RefusesWhatItCouldNotReadBack)
{
  const ScratchFile file(".csv");
  TrialLog log;
  TrialHead head = sampleHead();
  head.alternatives.pop_back();
  EXPECT_THAT(log.open(file.path(), head), HasSubstr("not 1"));
  head = sampleHead();
  head.alternatives.resize(27, { "more", 1.0 });
  EXPECT_THAT(log.open(file.path(), head), HasSubstr("not 27"));
  head = sampleHead();
  head.question = "One?\nOr two?";
  EXPECT_THAT(log.open(file.path(), head), HasSubstr(file.path()));
  EXPECT_FALSE(std::ifstream(file.path()).good());
}

TEST(TrialLog, BadFilesAreNamedWithTheirLine)
{
  const ScratchFile file(".csv");
  writeSample(file.path());
  const std::string good = contentOf(file.path());
  const auto replaced = [&good](const std::string& what, const std::string& by)
  {
    std::string text = good;
    return text.replace(text.find(what), what.size(), by);
  };
  const struct
  {
    std::string text;
    const char* place;
  } wrong[] = {
    { "", ":0: there is no line with the names of the columns" }, { "time_s,tip_x_mm\n", ":1:" },
    { replaced("trial 1\n", "trial 2\n"), ":1:" },
    { replaced("larger intensity", "louder one"), ":3:" },
    { replaced("alternative B", "alternative C"), ":6:" },
    { replaced("intensity B: 2.5", "intensity B: nan"), ":7:" },
    { replaced("seed: 18446744073709551615", "seed: 18446744073709551616"), ":8:" },
    { replaced("# started", "# ended"), ":11:" },
    { good.substr(0, good.find("# seed")), ":7: there is no line" },
    { replaced("# alternative B: friction=0.3\n# intensity B: 2.5\n", ""), ":10: the head" },
    { replaced("1,A,B,X,A,0,", "2,A,B,X,A,0,"), ":13:" }, // does not begin with 1
    { replaced("1,A,B,X,A,0,", "1,A,B,X,B,0,"), ":13:" }, // X was chosen, and X was A
    { replaced("1,A,B,X,A,0,", "1,A,B,X,A,1,"), ":13:" }, // the weaker alternative is not correct
    { replaced("1,A,B,X,A,0,", "1,A,C,X,A,0,"), ":13:" }, // there is no C
    { replaced("1,A,B,X,A,0,", "1,A,A,X,A,0,"), ":13:" }, // compared with itself
    { replaced("1,A,B,X,A,0,", "1,A,B,Z,A,0,"), ":13:" }, // neither X nor Y
    { replaced("1,A,B,X,A,0,", "1,A,B,X,A,"), ":13:" },   // a column is missing
    { replaced("12.5,7", "soon,7"), ":14:" },             //
    { replaced("12.5,7", "-12.5,7"), ":14:" },            //
    { replaced("12.5,7", "12.5,7.5"), ":14:" },           //
    { good.substr(0, good.size() - 1), ":15:" },          // the end of the last line is missing
    { good.substr(0, good.size() - 3), ":15:" },          //
  };
  for (const auto& [text, place] : wrong)
  {
    std::ofstream(file.path()) << text;
    TrialRecord record;
    record.answers.resize(5);
    const std::string error = readTrialLog(file.path(), record);
    EXPECT_THAT(error, HasSubstr(file.path()));
    EXPECT_THAT(error, HasSubstr(place));
    EXPECT_EQ(record.answers.size(), 5U); // no partial record
  }
  TrialRecord record;
  EXPECT_THAT(readTrialLog("/nowhere/at/all.csv", record), HasSubstr("/nowhere/at/all.csv"));
}
} // namespace trial_log
