// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Servo/ServoScene.h"

namespace palpate
{
ServoScene::ServoScene(const ServoScene& other)
  : body(other.body)
  , settings(other.settings)
  , contact(other.contact)
  , forceFactor(other.forceFactor)
{
}

ServoScene::~ServoScene()
{
  // One after the other: a long list would nest as deep.
  while (this->next)
  {
    this->next = std::move(this->next->next);
  }
}
} // namespace palpate
