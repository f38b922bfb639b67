// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_NumberRange_h
#define palpate_NumberRange_h

#include <limits>
#include <string>

namespace palpate
{
/// The range of a number that is given as text. The number must be finite and within bounds.
struct NumberRange
{
  static constexpr double Endless = std::numeric_limits<double>::infinity();

  /// Description of the number for the error, such as "a modulus in MPa, e.g. 0.05".
  const char* what;
  double least = -Endless;
  double most = Endless;
  bool includesLeast = true;

  static constexpr NumberRange any(const char* what) { return { what }; }
  static constexpr NumberRange positive(const char* what, double most = Endless)
  {
    return { what, 0.0, most, false };
  }
  static constexpr NumberRange notNegative(const char* what) { return { what, 0.0 }; }
  static constexpr NumberRange between(double least, double most, const char* what)
  {
    return { what, least, most };
  }

  /// Sets the number and returns "". If the text is not a valid number, returns a line with the
  /// reason, such as "0 is not positive; a modulus in MPa, e.g. 0.05", and leaves the number
  /// unchanged.
  std::string read(const std::string& text, double& number) const;
};
} // namespace palpate

#endif
