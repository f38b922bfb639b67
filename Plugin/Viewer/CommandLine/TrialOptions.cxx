// SPDX-License-Identifier: BSD-3-Clause
#include "TrialOptions.h"

#include "NumberRange.h"
#include "OptionChecks.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace palpate
{
void addTrialOptions(CLI::App& app, ViewerOptions& options, std::string& alternatives)
{
  app
    .add_option("--trial", alternatives,
      "compare blindly: A,B or more alternatives, each of them a tool, settings, or both, as in "
      "sphere:6.35+layer=7; settings: young, poisson, layer, layers, the options of friction, "
      "force and surface, as in friction=0.3, and with --scene phantom the words lump and none. In "
      "the window, space switches between X and Y, and 1 or 2 answers; without a window, answers "
      "are read from the standard input")
    ->check(CLI::Validator(
      [](const std::string& text)
      {
        std::vector<TrialChoice> ignored;
        return readTrialChoices(text, {}, ignored);
      },
      "A,B"));
  app
    .add_option("--rounds", options.trialRounds,
      "number of rounds of a trial; in each round every pair is asked twice, once in either order")
    ->check(within(NumberRange::between(1, 10000, "a number of rounds, e.g. 5"), "INT"))
    ->needs("--trial")
    ->capture_default_str();
  app
    .add_option("--seed", options.trialSeed,
      "seed of the order of a trial, to repeat an order (default: another seed each time)")
    ->check(within(NumberRange::notNegative("a whole number, e.g. 1"), "NONNEGATIVE"))
    ->needs("--trial");
  app
    .add_option("--question", options.question,
      "question of a trial (default: which one pushes back more, or, with lump and none, under "
      "which one the lump is; only these questions have a right answer)")
    ->needs("--trial");
  app
    .add_option("--log", options.trialLog,
      "file for the answers of a trial, a .csv that must not exist yet (default: trial.csv in the "
      "output folder)")
    ->needs("--trial");
  app.get_option("--trial")->excludes("--hand");
}

void takeTrialTools(ViewerOptions& options)
{
  const auto namesTool = [](const TrialChoice& choice) { return !choice.tool.empty(); };
  const auto named = std::count_if(options.trial.begin(), options.trial.end(), namesTool);
  if (named == 0)
  {
    return;
  }
  if (static_cast<std::size_t>(named) < options.trial.size() || !options.tools.empty())
  {
    throw CLI::ValidationError("--trial",
      options.tools.empty() ? "either all alternatives name a tool, or none does"
                            : "the alternatives name tools, so --tool cannot be given");
  }
  for (const TrialChoice& choice : options.trial)
  {
    const auto end = options.tools.end();
    if (std::find(options.tools.begin(), end, choice.tool) == end)
    {
      options.tools.push_back(choice.tool);
    }
  }
}
} // namespace palpate
