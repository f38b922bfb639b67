// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Display/SceneCaption.h"

#include "Interaction/Display/DisplayColors.h"
#include "Contact/ResponseContract.h"
#include "Interaction/Display/MemoryText.h"
#include "Interaction/Display/ShownContact.h"
#include "Mechanics/Files/NumberText.h"
#include "Response/Curves/StoredError.h"

#include "vtkMath.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr double Left = 16.0;        // left margin, pixels
constexpr double Bottom = 14.0;      // bottom margin, pixels
constexpr double LetterWidth = 0.52; // average width of a letter, as a fraction of the font size
constexpr double LineSpacing = 1.2;  // distance between lines, as a multiple of the font height
constexpr int FontSize = 17;
constexpr double BackgroundOpacity = 0.75;
constexpr int SmallFontSize = 14;
constexpr double NarrowWidth = 400.0; // width below which a picture counts as narrow, pixels

std::string millimetres(double length)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f mm", length);
  return text.data();
}

std::string newtons(const Eigen::Vector3d& force)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%#.3g N", force.norm());
  return text.data();
}

std::string degrees(double angle)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f degrees", vtkMath::DegreesFromRadians(angle));
  return text.data();
}

std::string newtonMillimetres(double torque)
{
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%#.3g N mm", torque);
  return text.data();
}

/// Returns the error of the force as text. Beyond validity the text has three digits, so that the
/// displayed error differs from the tolerance even if it is only slightly larger.
std::string errorOf(const ShownContact& contact)
{
  constexpr double rounded = 0.0995; // errors of 10 % and more have at least two digits anyway
  return contact.isValid() || !(contact.error < rounded)
    ? errorInWords(contact.error)
    : " \u00b1 " + shortly(100.0 * contact.error) + " %";
}

/// Returns the depth of the tool's own dent as text. If other tools lower the surface, the text
/// also gives the depth of the tip.
std::string deflectionOf(const ShownContact& contact)
{
  return millimetres(contact.tick.contact.deflection) +
    (contact.isLowered() ? " (tip " + millimetres(contact.tipDepth()) + " deep)" : "");
}

/// Breaks a text at blanks into lines of at most `letters` letters. A blank after a comma or a
/// colon is preferred.
std::string wrapped(const std::string& text, std::size_t letters)
{
  constexpr std::size_t none = std::string::npos;
  std::string result;
  std::size_t lineBegin = 0;
  std::size_t blank = none; // position of the last blank of the current line
  std::size_t pause = none; // position of the last blank after a comma or colon
  for (const char c : text)
  {
    if (c == ' ')
    {
      blank = result.size();
      pause = !result.empty() && (result.back() == ',' || result.back() == ':') ? blank : pause;
    }
    result += c;
    const bool pauses = pause != none && 3 * (pause - lineBegin) > letters;
    const std::size_t end = pauses ? pause : blank;
    if (c != '\n' && result.size() - lineBegin > letters && end != none)
    {
      result[end] = '\n';
      lineBegin = end + 1;
      blank = blank == end ? none : blank;
      pause = none;
    }
    else if (c == '\n')
    {
      lineBegin = result.size();
      blank = none;
      pause = none;
    }
  }
  return result;
}
} // namespace

SceneCaption::SceneCaption()
  : Actor(vtkSmartPointer<vtkTextActor>::New())
{
  vtkTextProperty* text = this->Actor->GetTextProperty();
  text->SetColor(TextColor.data());
  text->SetLineSpacing(LineSpacing);
  // The background is needed because the body may be behind the text.
  text->SetBackgroundColor(BackgroundColor.data());
  text->SetBackgroundOpacity(BackgroundOpacity);
  this->Actor->SetPosition(Left, Bottom);
}

SceneCaption::~SceneCaption() = default;

void SceneCaption::describe(
  const ShownContact& contact, const std::string& tool, double contactRadius, double exaggeration)
{
  std::string& text = this->Contact;
  text = "Tool: " + tool;
  if (contact.touches())
  {
    text += "\nDeflection " + deflectionOf(contact);
    text += contactRadius > 0.0 ? ", contact radius " + millimetres(contactRadius) : "";
    text += "\nForce " + newtons(contact.tick.idealForce);
    text += errorOf(contact);
    text += contact.hasFriction()
      ? ": normal " + newtons(contact.tick.idealForce - contact.tick.contact.friction) +
        ", friction " + newtons(contact.tick.contact.friction)
      : "";
    const double torque = contact.tick.contact.torque.norm();
    constexpr double upright = 1e-3; // rad; a smaller tilt is not mentioned
    if (contact.tick.contact.tilt > upright)
    {
      text += "\nTilted by " + degrees(contact.tick.contact.tilt);
      text += torque > 0.0 ? ", torque " + newtonMillimetres(torque) : "";
    }
    std::string memory =
      memoryInWords(contact.tick.contact.normalForce, contact.tick.contact.memory);
    if (!memory.empty())
    {
      memory.front() = 'O';
      text += "\n" + memory;
    }
  }
  if (contact.appliedDiffers())
  {
    text += "\nApplied " + newtons(contact.tick.appliedForce);
    text += contact.safety.empty() ? "" : ": " + contact.safety;
  }
  if (!contact.isValid())
  {
    const std::string limit = limitInWords(contact.limit);
    text += contact.validity > 0.0
      ? "\nDashed: beyond validity, which ends " + millimetres(contact.validity) + " deep"
      : "\nDashed: not valid at any depth";
    text += limit.empty() ? "" : " (" + limit + ")";
  }
  if (contact.touches() && exaggeration != 1.0)
  {
    text += "\nDent drawn x" + shortly(exaggeration);
  }
}

void SceneCaption::addHand(int number, const ShownContact& contact)
{
  this->Contact += "\nHand " + std::to_string(number) + ": ";
  this->Contact += contact.touches()
    ? "deflection " + deflectionOf(contact) + ", force " + newtons(contact.tick.idealForce)
    : std::string("touches nothing");
  this->Contact +=
    contact.appliedDiffers() ? ", applied " + newtons(contact.tick.appliedForce) : "";
  this->Contact += contact.isValid() ? "" : ", beyond validity";
}

void SceneCaption::write(double width)
{
  std::string all;
  for (const std::string& part : { this->Title, this->Contact, this->State, this->Remark })
  {
    all += all.empty() || part.empty() ? part : "\n" + part;
  }
  const int font = width < NarrowWidth ? SmallFontSize : FontSize;
  const double letters = std::max((width - 2.0 * Left) / (LetterWidth * font), 10.0);
  const std::string text = wrapped(all, static_cast<std::size_t>(letters));
  this->Actor->GetTextProperty()->SetFontSize(font);
  this->Actor->SetInput(text.c_str());
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  this->Height = Bottom + LineSpacing * font * static_cast<double>(lines);
}
} // namespace palpate
