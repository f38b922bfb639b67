// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ResponseContract.h"

#include <array>

namespace palpate
{
namespace
{
struct LimitWords
{
  const char* limit;
  const char* assumption;
};

constexpr std::array<LimitWords, ResponseLimitCount> Words = { { { "", "" },
  { "strain", "small strain" }, { "curvature of the body", "a flat surface" },
  { "layer thickness", "the thickness" }, { "the opposite wall", "the opposite wall" },
  { "an edge", "an edge" }, { "end of the measured data", "the end of the data" } } };

LimitWords wordsOf(int code) noexcept
{
  const auto place = static_cast<std::size_t>(code);
  return code > 0 && place < Words.size() ? Words[place] : Words.front();
}
} // namespace

const char* limitInWords(int code) noexcept
{
  return wordsOf(code).limit;
}

const char* assumptionInWords(int code) noexcept
{
  return wordsOf(code).assumption;
}

int modelPartsOfText(const std::string& model)
{
  const auto says = [&model](const char* word) { return model.find(word) != std::string::npos; };
  return (says("half-space") ? HalfSpacePart : 0) | (says("layer") ? LayerPart : 0) |
    (says("compliance") ? GlobalCompliancePart : 0) | (says("spring per point") ? SpringPart : 0);
}
} // namespace palpate
