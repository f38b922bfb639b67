// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TouchText.h"

#include "Response/Curves/StoredError.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
// vtkToolContactProbe's ContactState
constexpr int BeyondRange = 3;
constexpr int LostAtBorder = 4;
constexpr int Invalid = 5;

std::string millimetres(double length)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f mm", length);
  return text.data();
}

/// To three digits, of which a zero at the end is shown: it is known.
std::string threeDigits(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%#.3g", value);
  return text.data();
}

std::string shortest(double value)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

/// What is to be known of a contact beside its force; "" for one that is well.
std::string describeState(const Touch& touch)
{
  switch (touch.state)
  {
    case BeyondRange:
      return "\nPressed deeper than the response reaches, " + millimetres(touch.range);
    case LostAtBorder:
      return "\nBeyond the open border of the body: the force fades";
    case Invalid:
      return "\nNo response at this point: ResponseStatus says why";
    default:
      return "";
  }
}

std::string describeValidity(const Touch& touch)
{
  const PlaceValidity& validity = touch.validity;
  if (!validity.known)
  {
    return "";
  }
  const bool isWithin = touch.deflection <= validity.depth;
  std::string text = isWithin ? "\nWithin the law's validity" : "\nBeyond the law's validity";
  if (std::isfinite(validity.depth))
  {
    text += std::string(isWithin ? " (to " : " (") + millimetres(validity.depth);
    text += validity.limit.empty() ? ")" : ": " + validity.limit + ")";
  }
  return text;
}
} // namespace

std::string describeTouch(const Touch& touch, const std::string& tool)
{
  std::string text = "Tool: " + tool;
  if (!touch.touches() && touch.state != Invalid)
  {
    text += "\nNo contact";
    text += touch.nearest.cell >= 0
      ? ": the tip is " + millimetres(touch.nearest.distance) + " off the surface"
      : "";
    return text;
  }
  text += "\nForce " + threeDigits(touch.force.norm()) + " N";
  text += touch.state == Invalid ? "" : errorInWords(touch.validity.error);
  text += "\nDeflection " + millimetres(touch.deflection);
  text += ", stiffness " + threeDigits(touch.stiffness) + " N/mm";
  text += describeState(touch);
  text += touch.state == Invalid ? "" : describeValidity(touch);
  text += "\nArrow: " + shortest(touch.scale) + " mm per N";
  return text;
}
} // namespace palpate
