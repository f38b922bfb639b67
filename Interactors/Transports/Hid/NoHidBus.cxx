// SPDX-License-Identifier: BSD-3-Clause
// Replaces HidapiBus.cxx if there is no hidapi.
#include "Transports/Hid/HidBus.h"

namespace palpate
{
namespace
{
class NoHidBus final : public HidBus
{
public:
  std::vector<HidEntry> entries() override { return {}; }
  std::unique_ptr<HidPort> open(const std::string&, std::string& error) override
  {
    error = this->complaint();
    return nullptr;
  }
  std::string obstacle(const std::string&) override { return this->complaint(); }
  std::string complaint() const override
  {
    return "this Palpate was built without hidapi: it cannot use HID devices (libhidapi-dev, "
           "PALPATE_USE_HIDAPI)";
  }
};
} // namespace

HidBus& systemHidBus()
{
  static NoHidBus bus;
  return bus;
}
} // namespace palpate
