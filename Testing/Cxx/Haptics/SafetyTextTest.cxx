// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Safety/SafetyText.h"

#include "Haptics/Safety/SafetyChain.h"

#include <gtest/gtest.h>

#include <set>

using palpate::describeSafety;
using palpate::SafetyLink;

TEST(SafetyText, NamesTheFactorAndWhatElseActed)
{
  const auto bits = [](std::initializer_list<SafetyLink> links)
  {
    unsigned sum = 0;
    for (const SafetyLink link : links)
    {
      sum += static_cast<unsigned>(link);
    }
    return static_cast<std::uint16_t>(sum);
  };
  EXPECT_EQ(describeSafety(0, 0.12), "");
  EXPECT_EQ(describeSafety(bits({ SafetyLink::Fit }), 0.1234), "force \u00d70.12");
  EXPECT_EQ(describeSafety(bits({ SafetyLink::StiffnessCap, SafetyLink::Fit }), 0.5),
    "force \u00d70.5, stiffness capped");
  EXPECT_EQ(describeSafety(bits({ SafetyLink::Fit, SafetyLink::Slew }), 0.5, "too weak"),
    "force \u00d70.5 (too weak), rise limited");
  EXPECT_EQ(palpate::describeForceFactor(1.0), "force \u00d71");
}

TEST(SafetyText, EveryLinkHasWordsOfItsOwn)
{
  std::set<std::string> words;
  for (unsigned bit = 1; bit <= static_cast<unsigned>(SafetyLink::Stopped); bit <<= 1)
  {
    const std::string text = describeSafety(static_cast<std::uint16_t>(bit), 0.5);
    EXPECT_FALSE(text.empty()) << "bit " << bit;
    EXPECT_TRUE(words.insert(text).second) << text;
  }
  EXPECT_EQ(words.size(), 10U);
}
