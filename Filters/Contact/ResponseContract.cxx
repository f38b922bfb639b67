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
  { "an edge", "an edge" }, { "the measured data", "the measured data" },
  { "the finite elements", "the finite elements" },
  { "the tilt of the tool", "an upright tool" } } };

struct ContactWords
{
  const char* state;
  const char* remark;
};

// The texts for each ContactState, in the order of the enumeration.
constexpr std::array<ContactWords, 7> Contacts = { { { "no contact", "" },
  { "contact, sticking", "" }, { "contact, sliding", "" },
  { "contact, beyond range", "Pressed deeper than the response reaches" },
  { "lost at the border", "Beyond the open border of the body: the force fades" },
  { "no response there", "No response at this point: ResponseStatus gives the reason" },
  { "contact, tilted too far",
    "Tilted further than the response reaches: the force is that of its largest tilt" } } };

ContactWords contactWordsOf(int state) noexcept
{
  const auto place = static_cast<std::size_t>(state);
  return state >= 0 && place < Contacts.size() ? Contacts[place] : ContactWords{ "unknown", "" };
}

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

const char* contactInWords(int state) noexcept
{
  return contactWordsOf(state).state;
}

const char* contactRemark(int state) noexcept
{
  return contactWordsOf(state).remark;
}

int modelPartsOfText(const std::string& model)
{
  const auto says = [&model](const char* word) { return model.find(word) != std::string::npos; };
  return (says("half-space") ? HalfSpacePart : 0) | (says("layer") ? LayerPart : 0) |
    (says("compliance") ? GlobalCompliancePart : 0) | (says("spring per point") ? SpringPart : 0);
}
} // namespace palpate
