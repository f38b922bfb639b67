// SPDX-License-Identifier: BSD-3-Clause
// palpateStability PART [--quick] prints the rows of one part of the stability study as CSV on the
// standard output. All runs are in virtual time, so that the results are the same on every machine.
#include "Parts.h"

#include <cstdio>
#include <cstring>
#include <map>
#include <string>

int main(int argc, char* argv[])
{
  using namespace palpate::testing;
  const std::map<std::string, void (*)(bool)> parts{ { "limits", stiffnessLimits },
    { "encoder", encoderLimits }, { "press", pressedUntilItBuzzes },
    { "cylinder", cylinderSettings }, { "leak", holdLeak }, { "friction", frictionInTheLoop },
    { "geometry", unkindGeometry }, { "faults", deviceFailures }, { "relaxing", relaxingLimits },
    { "relaxing-press", relaxingPress }, { "relaxing-paths", relaxingPaths },
    { "hands", handsLimits }, { "hands-press", handsPress } };
  const auto part = parts.find(argc > 1 ? argv[1] : "");
  if (part == parts.end())
  {
    std::fputs("usage: palpateStability PART [--quick], PART one of:", stderr);
    for (const auto& [name, run] : parts)
    {
      std::fprintf(stderr, " %s", name.c_str());
    }
    std::fputs("\n", stderr);
    return 2;
  }
  part->second(argc > 2 && std::strcmp(argv[2], "--quick") == 0);
  return 0;
}
