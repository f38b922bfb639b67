// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SettingFault_h
#define palpate_SettingFault_h

#include <sstream>
#include <string>

namespace palpate
{
/// A fault of one setting; none if the name is empty.
struct SettingFault
{
  std::string name;   ///< name of the filters' property, "FrictionCoefficient"
  std::string remark; ///< "must be finite and not negative, but is -1"

  /// The fault of a value that is not allowed; `demand` continues after "must": "be positive".
  template <class Value>
  static SettingFault must(const std::string& name, const std::string& demand, const Value& is)
  {
    std::ostringstream remark;
    remark << "must " << demand << ", but is " << is;
    return { name, remark.str() };
  }

  explicit operator bool() const noexcept { return !this->name.empty(); }
  /// Name and remark as a clause; "" without fault.
  std::string words() const { return *this ? this->name + ' ' + this->remark : std::string(); }
};
} // namespace palpate

#endif
