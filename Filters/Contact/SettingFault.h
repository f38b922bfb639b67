// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SettingFault_h
#define palpate_SettingFault_h

#include <sstream>
#include <string>

namespace palpate
{
/// Returns the name of a property in words, as in ParaView's property panel: "Friction
/// Coefficient", "Poisson's Ratio".
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

/// A fault of one setting. If the name is empty, there is no fault.
struct SettingFault
{
  std::string name;   ///< name of the property of the filters, "FrictionCoefficient"
  std::string remark; ///< text such as "must be finite and not negative, but is -1"

  /// Returns the fault of a value that is not allowed. `demand` continues the phrase "must", for
  /// example "be positive".
  template <class Value>
  static SettingFault must(const std::string& name, const std::string& demand, const Value& is)
  {
    std::ostringstream remark;
    remark << "must " << demand << ", but is " << is;
    return { name, remark.str() };
  }

  explicit operator bool() const noexcept { return !this->name.empty(); }
  /// Returns the name in words followed by the remark: "Friction Coefficient must be …"; "" if
  /// there is no fault.
  std::string words() const
  {
    return *this ? settingInWords(this->name) + ' ' + this->remark : std::string();
  }
};
} // namespace palpate

#endif
