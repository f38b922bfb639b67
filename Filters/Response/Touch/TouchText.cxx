// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Touch/TouchText.h"

#include "Contact/ResponseContract.h"
#include "Response/Curves/StoredError.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace palpate
{
namespace
{
std::string millimetres(double length)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f mm", length);
  return text.data();
}

/// Formats a number with three significant digits, including trailing zeros.
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

std::string describeState(const Touch& touch)
{
  const std::string remark = contactRemark(static_cast<int>(touch.contact.state));
  const bool isBeyond = touch.contact.state == ContactState::BeyondRange;
  return (remark.empty() ? "" : "\n" + remark) + (isBeyond ? ", " + millimetres(touch.range) : "");
}

std::string describeValidity(const Touch& touch)
{
  const PlaceValidity& validity = touch.validity;
  if (!validity.known)
  {
    return "";
  }
  const bool isWithin = touch.contact.deflection <= validity.depth;
  std::string text = isWithin ? "\nWithin the law's validity" : "\nBeyond the law's validity";
  if (std::isfinite(validity.depth))
  {
    text += std::string(isWithin ? " (to " : " (") + millimetres(validity.depth);
    text += validity.limit.empty() ? ")" : ": " + validity.limit + ")";
  }
  return text;
}
/// Describes one touch. The text begins with a newline.
std::string describeTouch(const Touch& touch)
{
  std::string text;
  const bool isInvalid = touch.contact.state == ContactState::Invalid;
  if (!touch.touches() && !isInvalid)
  {
    text += "\nNo contact";
    text += touch.nearest.cell >= 0
      ? ": the tip is " + millimetres(touch.nearest.distance) + " off the surface"
      : "";
    return text;
  }
  text += "\nForce " + threeDigits(touch.contact.force.norm()) + " N";
  text += isInvalid ? "" : errorInWords(touch.validity.error);
  text += "\nDeflection " + millimetres(touch.contact.deflection);
  text += touch.sunk != 0.0 ? ", " + millimetres(touch.sunk) + " less by the other tip" : "";
  text += ", stiffness " + threeDigits(touch.stiffness) + " N/mm";
  text += describeState(touch);
  text += isInvalid ? "" : describeValidity(touch);
  return text;
}
} // namespace

std::string describeTouches(const std::vector<Touch>& touches, const std::string& tool)
{
  std::string text = "Tool: " + tool;
  bool isForce = false;
  for (std::size_t i = 0; i < touches.size(); ++i)
  {
    text += i > 0 ? "\nSecond tip" : "";
    text += describeTouch(touches[i]);
    isForce = isForce || touches[i].touches() || touches[i].contact.state == ContactState::Invalid;
  }
  text += isForce ? "\nArrow: " + shortest(touches.front().scale) + " mm per N" : "";
  text += touches.front().isAlone ? "\nThe tips do not interact: the response has no Coupling" : "";
  return text;
}
} // namespace palpate
