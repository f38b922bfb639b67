// SPDX-License-Identifier: BSD-3-Clause
// A long session with faults of every kind. Each of its ticks is checked. Exit code: 0 if all
// requirements hold, 1 if not, 2 for a wrong call or without a display.
#include "SoakRun.h"

#include <CLI/CLI.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace
{
int soak(const palpate::endurance::SoakOptions& options, const std::string& output)
{
  palpate::endurance::SoakRun run(options);
  const std::string error = run.start();
  if (!error.empty())
  {
    std::cerr << "palpateSoak: " << error << "\n";
    return 1;
  }
  run.run();
  const palpate::endurance::SoakResult result = run.finish();
  result.print(std::cout);
  if (!output.empty())
  {
    std::ofstream file(output);
    result.writeJson(file);
    if (!file.flush())
    {
      std::cerr << "palpateSoak: cannot write '" << output << "'\n";
      return 1;
    }
  }
  return result.complaints().empty() ? 0 : 1;
}
} // namespace

int main(int argc, char* argv[])
{
  palpate::endurance::SoakOptions options;
  std::string output;
  CLI::App app("A servo session at full rate, every tick of which is checked against a model of "
               "its own, while bodies are swapped, devices come and go, and a picture is drawn.",
    "palpateSoak");
  app.add_option("--seconds", options.seconds, "How long, s")->check(CLI::Range(1.0, 1e6));
  app.add_option("--rate", options.rate, "Ticks per second")->check(CLI::Range(100.0, 2e4));
  app.add_option("--seed", options.seed, "Of all that is random");
  app.add_option("--output", output, "A JSON file for the figures");
  bool isBlind = false;
  app.add_flag("--no-drawing", isBlind, "Without a picture, where there is no display");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 2;
  }
  options.draws = !isBlind;
  const char* const display = std::getenv("DISPLAY");
  if (options.draws && (display == nullptr || *display == '\0'))
  {
    std::cerr << "palpateSoak: no display to draw on (DISPLAY); see --no-drawing\n";
    return 2;
  }
  return soak(options, output);
}
