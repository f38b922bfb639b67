// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TrialScore_h
#define palpate_TrialScore_h

#include "Mechanics/PalpateExport.h"
#include "Trials/Proportion.h"
#include "Trials/TrialLog.h"

#include <string>
#include <vector>

namespace palpate
{
/// The result for two alternatives. The intervals are those of proportionOf with 95 % confidence.
struct PairScore
{
  int first = 0; ///< index of the first alternative
  int second = 0;
  Proportion firstChosen; ///< fraction of the trials in which the first alternative was chosen
  bool hasRightAnswer = false;
  Proportion correct; ///< fraction of the trials in which the alternative with the larger intensity
                      ///< was chosen
  /// Difference of the two intensities relative to their mean; 0 if there is no right answer.
  double difference = 0.0;
  /// The relative difference that would be recognised in 75 % of the trials, computed from the
  /// estimate and from both ends of the interval. Infinite if the answers are no better than
  /// guesses, 0 if all answers are right.
  double justNoticeable = 0.0;
  double justNoticeableLower = 0.0;
  double justNoticeableUpper = 0.0;
};

/// The result of a blind comparison.
struct TrialScore
{
  Proportion xChosen; ///< fraction of the trials in which X was chosen; if the interval excludes
                      ///< 0.5, X is preferred or avoided
  std::vector<PairScore> pairs; ///< one element for each pair that was asked
};

/**
 * Scores a record.
 *
 * The just-noticeable difference is computed by the model of two noisy impressions of equal
 * variance (Thurstone 1927; Green and Swets 1966, two-alternative forced choice). The fraction of
 * right answers is p = Φ(d′/√2), and d′ is proportional to the difference D. Therefore 75 % of the
 * answers are right at the difference D Φ⁻¹(0.75) / Φ⁻¹(p).
 */
PALPATE_EXPORT TrialScore scoreTrials(const TrialRecord& record);

/// Describes the score as readable text, one string per line.
PALPATE_EXPORT std::vector<std::string> describeScore(
  const TrialHead& head, const TrialScore& score);
} // namespace palpate

#endif
