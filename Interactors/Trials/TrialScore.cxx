// SPDX-License-Identifier: BSD-3-Clause
#include "Trials/TrialScore.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace palpate
{
namespace
{
constexpr double Criterion = 0.75; // half-way between guessing (0.5) and certainty (1)

/// Returns the difference that is recognised in the fraction Criterion of the trials, if
/// `difference` is recognised in the fraction `share` of the trials.
double differenceAtCriterion(double difference, double share)
{
  return share > 0.5 ? difference * normalQuantile(Criterion) / normalQuantile(share)
                     : std::numeric_limits<double>::infinity();
}

struct Count
{
  int trials = 0;
  int firstChosen = 0;
  int right = 0;
};

PairScore scorePair(const TrialHead& head, const std::pair<int, int>& pair, const Count& count)
{
  PairScore score;
  score.first = pair.first;
  score.second = pair.second;
  score.firstChosen = proportionOf(count.firstChosen, count.trials);
  const double a = head.alternatives[static_cast<std::size_t>(pair.first)].intensity;
  const double b = head.alternatives[static_cast<std::size_t>(pair.second)].intensity;
  score.hasRightAnswer = head.hasRightAnswer && a != b;
  if (score.hasRightAnswer)
  {
    score.correct = proportionOf(count.right, count.trials);
    score.difference = std::abs(a - b) / (0.5 * std::abs(a + b));
    score.justNoticeable = differenceAtCriterion(score.difference, score.correct.share);
    score.justNoticeableLower = differenceAtCriterion(score.difference, score.correct.upper);
    score.justNoticeableUpper = differenceAtCriterion(score.difference, score.correct.lower);
  }
  return score;
}

std::string inWords(const Proportion& proportion)
{
  const auto whole = [](double share) { return std::to_string(std::lround(100.0 * share)); };
  return std::to_string(proportion.successes) + " of " + std::to_string(proportion.trials) + ", " +
    whole(proportion.share) + " % (95 %: " + whole(proportion.lower) + " to " +
    whole(proportion.upper) + " %)";
}

std::string inWords(double difference)
{
  std::ostringstream text;
  text << std::setprecision(3) << 100.0 * difference << " %";
  return std::isfinite(difference) ? text.str() : "no limit";
}

/// Returns the verdict, according to the confidence interval, on whether the two alternatives were
/// distinguished.
const char* verdict(const Proportion& correct)
{
  if (correct.lower > 0.5)
  {
    return "distinguished";
  }
  return correct.upper < 0.5 ? "distinguished, but in the wrong order" : "not distinguished";
}
} // namespace

TrialScore scoreTrials(const TrialRecord& record)
{
  std::map<std::pair<int, int>, Count> counts;
  int xChosen = 0;
  for (const TrialAnswer& answer : record.answers)
  {
    const auto pair = std::minmax(answer.trial.x, answer.trial.y);
    Count& count = counts[{ pair.first, pair.second }];
    count.trials += 1;
    count.firstChosen += answer.choseX == (answer.trial.x == pair.first) ? 1 : 0;
    count.right += isRight(record.head, answer) == 1 ? 1 : 0;
    xChosen += answer.choseX ? 1 : 0;
  }
  TrialScore score;
  score.xChosen = proportionOf(xChosen, static_cast<int>(record.answers.size()));
  for (const auto& [pair, count] : counts)
  {
    score.pairs.push_back(scorePair(record.head, pair, count));
  }
  return score;
}

std::vector<std::string> describeScore(const TrialHead& head, const TrialScore& score)
{
  std::vector<std::string> lines;
  for (const PairScore& pair : score.pairs)
  {
    const std::string& first = head.alternatives[static_cast<std::size_t>(pair.first)].name;
    const std::string& second = head.alternatives[static_cast<std::size_t>(pair.second)].name;
    std::string chosen = first;
    chosen.append(" against ").append(second).append(": ").append(first);
    lines.push_back(chosen.append(" chosen in ").append(inWords(pair.firstChosen)));
    if (pair.hasRightAnswer)
    {
      lines.push_back("  right in " + inWords(pair.correct) + ": " + verdict(pair.correct));
      lines.push_back("  they differ by " + inWords(pair.difference) +
        "; just noticeable (75 % right): " + inWords(pair.justNoticeable) + " (95 %: " +
        inWords(pair.justNoticeableLower) + " to " + inWords(pair.justNoticeableUpper) + ")");
    }
  }
  lines.push_back("X, the first of each two, chosen in " + inWords(score.xChosen));
  return lines;
}
} // namespace palpate
