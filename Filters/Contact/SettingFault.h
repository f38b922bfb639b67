// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SettingFault_h
#define palpate_SettingFault_h

#include <string>

namespace palpate
{
/// What is wrong with one setting; nothing if there is no name.
struct SettingFault
{
  std::string name;   ///< as the filters' property, "FrictionCoefficient"
  std::string remark; ///< "must be finite and not negative, but is -1"

  explicit operator bool() const noexcept { return !this->name.empty(); }
};
} // namespace palpate

#endif
