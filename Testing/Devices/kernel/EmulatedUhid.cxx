// SPDX-License-Identifier: BSD-3-Clause
// Implements the EmulatedHid of the umockdev tests with the real kernel.
#include "EmulatedHid.h"

#include "UhidDevice.h"

#include <utility>

namespace palpate::testing
{
EmulatedHid::EmulatedHid(HidModel model)
  : Model(std::move(model))
  , Uhid(std::make_shared<UhidDevice>(this->Model))
{
  this->Path = this->Uhid->path();
}

EmulatedHid::~EmulatedHid() = default;

bool EmulatedHid::send(const std::uint8_t* bytes, std::size_t size)
{
  return this->Uhid->send(bytes, size);
}

bool EmulatedHid::receive(std::vector<std::uint8_t>& report, std::size_t)
{
  return this->Uhid->receive(report);
}

void EmulatedHid::unplug()
{
  this->Uhid->unplug();
}
} // namespace palpate::testing
