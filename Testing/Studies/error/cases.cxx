// SPDX-License-Identifier: BSD-3-Clause
/*
 * Compares stated and true errors of forces at random contacts. Prints a row per law and depth.
 *
 *   palpateErrorCases FAMILY COUNT SEED     FAMILY: half-space, layer, stack, ball, cavity
 *
 * Cost: 5 to 20 s of processor time for each contact.
 */
#include "RandomContact.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

using namespace palpate::testing;

int main(int count, char** arguments)
{
  const std::string wanted = count == 4 ? arguments[1] : "";
  const auto found =
    std::find(std::begin(ContactFamilyNames), std::end(ContactFamilyNames), wanted);
  if (found == std::end(ContactFamilyNames))
  {
    std::fprintf(stderr, "usage: %s half-space|layer|stack|ball|cavity COUNT SEED\n", arguments[0]);
    return 1;
  }
  const auto family = static_cast<ContactFamily>(found - std::begin(ContactFamilyNames));
  std::mt19937 random(static_cast<unsigned>(std::atoi(arguments[3])));
  std::printf(
    "family,tool,body,law,depth_mm,contact_radius_mm,force_N,exact_N,stated,error,limit\n");
  for (int i = 0; i < std::atoi(arguments[2]); ++i)
  {
    const RandomContact contact = drawContact(family, random);
    for (const JudgedForce& at : contact.forces)
    {
      std::printf("%s,\"%s\",\"%s\",%s,%.6g,%.6g,%.6g,%.6g,%.5f,%.5f,%d\n", wanted.c_str(),
        contact.tool.c_str(), contact.body.c_str(), at.law.c_str(), at.depth, at.radius, at.force,
        at.exact, at.stated, at.error(), static_cast<int>(at.limit));
    }
    if (!contact.fault.empty())
    {
      std::fprintf(stderr, "%s, %s, %s: %s\n", wanted.c_str(), contact.tool.c_str(),
        contact.body.c_str(), contact.fault.c_str());
    }
    std::fflush(stdout);
  }
  return 0;
}
