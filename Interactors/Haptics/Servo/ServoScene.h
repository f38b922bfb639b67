// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ServoScene_h
#define palpate_ServoScene_h

#include "Contact/ToolContact.h"

#include <memory>
#include <utility>

namespace palpate
{
/**
 * A body with the response of a tool, as one ServoStep renders it: another body, tool, material or
 * other settings are another scene. Made and freed outside of the tick, which only hands it on.
 */
struct ServoScene
{
  /// `contactBody` must not be null and is kept alive by the scene. `sceneForceFactor` (0, 1] fits
  /// this scene to the device, beside SafetySettings::forceFactor: their product is what counts.
  /// Outside of its range it gives no force.
  explicit ServoScene(std::shared_ptr<const ContactBody> contactBody,
    const ContactSettings& contactSettings = {}, double sceneForceFactor = 1.0)
    : body(std::move(contactBody))
    , settings(contactSettings)
    , contact(*this->body, contactSettings)
    , forceFactor(sceneForceFactor > 0.0 && sceneForceFactor <= 1.0 ? sceneForceFactor : 0.0)
  {
  }
  ~ServoScene()
  {
    // One after the other: a long list would nest as deep.
    while (this->next)
    {
      this->next = std::move(this->next->next);
    }
  }
  /// With its history, but alone.
  ServoScene(const ServoScene& other)
    : body(other.body)
    , settings(other.settings)
    , contact(other.contact)
    , forceFactor(other.forceFactor)
  {
  }
  ServoScene& operator=(const ServoScene&) = delete;

  const std::shared_ptr<const ContactBody> body;
  const ContactSettings settings;
  ToolContact contact;
  const double forceFactor;
  /// Scenes no longer needed are a list: freeing the first frees all.
  std::unique_ptr<ServoScene> next;
};
} // namespace palpate

#endif
