// SPDX-License-Identifier: BSD-3-Clause
// The data contract: its codes as in saved files, its texts and its names.
#include "Contact/Contact.h"
#include "Contact/ResponseContract.h"
#include "Contact/TermTable.h"

#include <gtest/gtest.h>

#include <algorithm>
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
  for (const int code : { 0, -1, 9, 255, INT_MIN, INT_MAX })
  {
    EXPECT_STREQ(limitInWords(code), "");
    EXPECT_STREQ(assumptionInWords(code), "");
  }
}

TEST(ContactWords, EachStateHasItsOwnAndOnlyWhatIsAmissARemark)
{
  std::set<std::string> words;
  for (int state = 0; state <= static_cast<int>(ContactState::TiltedTooFar); ++state)
  {
    words.insert(contactInWords(state));
    EXPECT_EQ(std::string(contactRemark(state)).empty(), state < 3) << state;
  }
  EXPECT_EQ(words.size(), 7U);
  EXPECT_EQ(words.count("unknown"), 0U);
  EXPECT_STREQ(contactInWords(static_cast<int>(ContactState::Stick)), "contact, sticking");
  EXPECT_STREQ(contactInWords(static_cast<int>(ContactState::LostAtBorder)), "lost at the border");
  for (const int other : { -1, 7, INT_MIN, INT_MAX })
  {
    EXPECT_STREQ(contactInWords(other), "unknown");
    EXPECT_STREQ(contactRemark(other), "");
  }
}

TEST(ResponseStatusCodes, AreThoseOfSavedFiles)
{
  EXPECT_EQ(static_cast<int>(ResponseStatus::Valid), 0);
  EXPECT_EQ(static_cast<int>(ResponseStatus::Degenerate), 1);
  EXPECT_EQ(static_cast<int>(ResponseStatus::NotFinite), 2);
  EXPECT_EQ(static_cast<int>(ResponseStatus::Folded), 3);
  EXPECT_EQ(static_cast<int>(ResponseStatus::OutOfReach), 4);
  EXPECT_EQ(static_cast<int>(ResponseStatus::Edge), 5);
}

TEST(ResponseContract, EachArrayStandsOnceUnderItsName)
{
  std::set<std::string> names;
  for (const ContractArray& array : ResponseContract)
  {
    EXPECT_EQ(&contractOf(array.array), &array);
    EXPECT_TRUE(names.insert(array.suffix).second) << array.suffix;
    EXPECT_STRNE(array.meaning, "") << array.suffix;
  }
  EXPECT_EQ(arrayName("Punch", ResponseArray::Stiffness), "PunchStiffness");
}

// A tick must not read numbers that were not checked.
TEST(TermTable, EachTermThatATickReadsIsChecked)
{
  using Use = ContractArray::Use;
  for (const ContractArray& array : ResponseContract)
  {
    const bool isTerm = array.isEvaluated() && array.use != Use::Evaluation &&
      array.use != Use::PerPoint && array.use != Use::Compact;
    const auto rows = std::count_if(TermTable.begin(), TermTable.end(),
      [&array](const TermRow& row) { return row.use == array.use; });
    EXPECT_EQ(rows, isTerm ? 1 : 0) << array.suffix;
  }
}

TEST(TermTable, NamesTheFirstWrongTerm)
{
  ResponseArrays response;
  response.points = 1;
  EXPECT_EQ(faultOfTerms(response), "");
  const float wrong = -1.0F;
  response.relaxation.series.add(0.5, 1.0);
  response.relaxation.elasticCompliance = &wrong;
  EXPECT_EQ(faultOfTerms(response), "has an elastic compliance of -1 at point 0");
  response.edges = { 1.5, 2.0, 0.7, 0.0, false };
  EXPECT_EQ(faultOfTerms(response).rfind("has edges that cannot be used: ", 0), 0U);
}

TEST(ResponseContract, WidthsFollowSamplesAndLaws)
{
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::Force), 8, 3), 8);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::Basis), 8, 3), 16);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::Coefficient), 8, 3), 3);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::Normal), 8, 3), 3);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::Status), 8, 3), 1);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::RelaxationTime), 8, 3, 2), 1);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::LocalRelaxation), 8, 3, 2), 2);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::ElasticCompliance), 8, 3, 2), 1);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::Coupling), 8, 3), 3);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::CouplingModes), 8, 3, 2, 6), 6);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::Tilt), 8, 3), 7);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::TiltDrop), 8, 3), 2);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::TiltNode), 8, 3), 4);
  EXPECT_EQ(componentsOf(contractOf(ResponseArray::TiltWeight), 8, 3, 2, 6, 5), 5);
}

// Texts from versions without model parts.
TEST(ModelParts, OfOldTexts)
{
  EXPECT_EQ(modelPartsOfText("half-space"), HalfSpacePart);
  EXPECT_EQ(modelPartsOfText("layer bonded to a rigid base, 3 mm thick"), LayerPart);
  EXPECT_EQ(modelPartsOfText("layer slipping on a rigid base of varying thickness in series with "
                             "global compliance"),
    LayerPart | GlobalCompliancePart);
  EXPECT_EQ(modelPartsOfText("half-space in series with global compliance; as a spring per point"),
    HalfSpacePart | GlobalCompliancePart | SpringPart);
  EXPECT_EQ(modelPartsOfText(""), 0);
}
