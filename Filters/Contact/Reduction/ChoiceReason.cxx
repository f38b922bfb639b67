// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/Reduction/ChoiceReason.h"

#include "Contact/ResponseContract.h"

#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{
/// Returns the range of values as text, "1" or "0.5 to 1".
std::string text(const ChoiceSpread& spread)
{
  std::ostringstream words;
  words.precision(3);
  words << spread.least;
  const std::string least = words.str();
  words.str({});
  words << spread.most;
  return least == words.str() ? least : least + " to " + words.str();
}

/// Returns the fraction in percent, rounded down, so that "100 %" means all points.
std::string percentOfPoints(double share)
{
  std::ostringstream words;
  words.precision(3);
  words << std::floor(1000.0 * share + 1e-9) / 10.0 << " % of the points";
  return words.str();
}

std::string percent(double error)
{
  std::ostringstream words;
  words.precision(2);
  words << 100.0 * error << " %";
  return words.str();
}

/// Describes the error of the chosen form, separately for the points within the tolerance and the
/// other points.
std::string errorOf(const ResponseChoice& choice, const ChoiceSettings& settings)
{
  return choice.keptShare == 1.0
    ? percent(choice.largestError) + " at most"
    : percent(settings.tolerance) + " at most at " + percentOfPoints(choice.keptShare) + " and " +
      percent(choice.largestError) + " at the worst of the others";
}

std::string taken(const ResponseChoice& choice, const ChoiceSettings& settings)
{
  const std::string range = text(choice.range) + " mm";
  const std::string error = errorOf(choice, settings);
  const std::string off = "the force is off by " + error + " down to " + range;
  switch (choice.need)
  {
    case ResponseNeed::PointForce:
      return "a point force suffices: the shape of the tool is not felt " + text(choice.depth) +
        " mm deep at " + percentOfPoints(choice.shapelessShare) + ", and a spring of " +
        text(choice.spring) + " N/mm in its place is off by " + error + " of the force at " + range;
    case ResponseNeed::OneLaw:
      return choice.largestError == 0.0
        ? "one law suffices: all points have the same curve down to " + range
        : "one law suffices: " + off;
    case ResponseNeed::ScaledLaw:
      return "one law suffices, times a number per point: " + off;
    case ResponseNeed::FewLaws:
      return std::to_string(choice.laws) + " laws suffice, combined at each point: " + off;
    case ResponseNeed::PerVertex:
      break;
  }
  return "a response per vertex is needed: " + std::to_string(settings.mostLaws) +
    " laws do not keep the force within " + percent(settings.tolerance) + " down to " + range +
    (settings.share < 1.0 ? " at " + percentOfPoints(settings.share) : std::string());
}

/// Returns the reason why no point force was chosen.
std::string noPointForce(const ResponseChoice& choice, const ChoiceSettings& settings)
{
  if (!choice.regimeKnown || choice.need == ResponseNeed::PointForce)
  {
    return {};
  }
  const std::string depth = text(choice.depth) + " mm deep";
  if (choice.springTried)
  {
    return "; the shape of the tool is not felt " + depth +
      ", but a spring per point would be off by " + percent(choice.springLoss) +
      " of the force at " + text(choice.range) + " mm";
  }
  if (choice.shapelessShare < settings.share)
  {
    return "; the shape of the tool is felt " + depth + " at " +
      percentOfPoints(1.0 - choice.shapelessShare);
  }
  return "; the shape of the tool is not felt " + depth +
    ", but the law on which this is based does not hold";
}

std::string beyondValidity(const ResponseChoice& choice)
{
  if (!choice.validityKnown || choice.beyondShare == 0.0)
  {
    return {};
  }
  const std::string assumption = assumptionInWords(choice.firstLimit);
  return "; " + text(choice.depth) + " mm is beyond the validity of the law at " +
    percentOfPoints(choice.beyondShare) +
    (assumption.empty() ? assumption : " (mostly " + assumption + ")") +
    ": its numbers are kept there, but do not describe the body";
}
} // namespace

std::string choiceReason(const ResponseChoice& choice, const ChoiceSettings& settings, int before)
{
  if (choice.points == 0)
  {
    return "no point has a response";
  }
  const std::string numbers = choice.need == ResponseNeed::PerVertex
    ? "; all " + std::to_string(before) + " numbers per point stay"
    : "; " + std::to_string(choice.numbersPerPoint) + " instead of " + std::to_string(before) +
      " numbers per point";
  return taken(choice, settings) + numbers + noPointForce(choice, settings) +
    beyondValidity(choice);
}
} // namespace palpate
