// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SettingFault_h
#define palpate_SettingFault_h

#include <sstream>
#include <string>

namespace palpate
{
/// The name of a property in words, as on a panel: "Friction Coefficient", "Poisson's Ratio".
inline std::string settingInWords(const std::string& name)
{
  if (name == "PoissonRatio")
  {
    return "Poisson's Ratio";
  }
  std::string words;
  for (const char letter : name)
  {
    words += words.empty() || letter < 'A' || letter > 'Z' ? "" : " ";
    words += letter;
  }
  return words;
}

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
  /// Name in words and remark as a clause, "Friction Coefficient must be …"; "" without fault.
  std::string words() const
  {
    return *this ? settingInWords(this->name) + ' ' + this->remark : std::string();
  }
};
} // namespace palpate

#endif
