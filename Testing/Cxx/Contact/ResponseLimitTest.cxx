// SPDX-License-Identifier: BSD-3-Clause
// The codes of the array Limit, as the data contract numbers them, and their words.
#include "Contact/ResponseLimit.h"

#include <gtest/gtest.h>

#include <climits>
#include <set>
#include <string>

using namespace palpate;

TEST(ResponseLimit, CodesAreThoseOfSavedFiles)
{
  EXPECT_EQ(static_cast<int>(ResponseLimit::None), 0);
  EXPECT_EQ(static_cast<int>(ResponseLimit::Strain), 1);
  EXPECT_EQ(static_cast<int>(ResponseLimit::Curvature), 2);
  EXPECT_EQ(static_cast<int>(ResponseLimit::Thickness), 3);
  EXPECT_EQ(static_cast<int>(ResponseLimit::OppositeWall), 4);
  EXPECT_EQ(static_cast<int>(ResponseLimit::Edge), 5);
  EXPECT_EQ(static_cast<int>(ResponseLimit::DataEnd), 6);
}

TEST(ResponseLimit, EachHasWordsOfItsOwn)
{
  std::set<std::string> limits;
  std::set<std::string> assumptions;
  for (int code = 1; code < static_cast<int>(ResponseLimitCount); ++code)
  {
    limits.insert(limitInWords(code));
    assumptions.insert(assumptionInWords(code));
  }
  EXPECT_EQ(limits.size(), ResponseLimitCount - 1);
  EXPECT_EQ(assumptions.size(), ResponseLimitCount - 1);
  EXPECT_EQ(limits.count(""), 0U);
  EXPECT_EQ(assumptions.count(""), 0U);
}

TEST(ResponseLimit, OtherNumbersHaveNone)
{
  for (const int code : { 0, -1, 7, 255, INT_MIN, INT_MAX })
  {
    EXPECT_STREQ(limitInWords(code), "");
    EXPECT_STREQ(assumptionInWords(code), "");
  }
}
