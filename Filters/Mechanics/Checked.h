// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Checked_h
#define palpate_Checked_h

#include <string>
#include <utility>
#include <variant>

namespace palpate
{
/// An error message.
struct Fault
{
  std::string text;
};

/// Either a value, or the reason why there is no value.
template <class T>
class [[nodiscard]] Checked
{
public:
  Checked(T value) // NOLINT(google-explicit-constructor): allows `return value;`
    : Content(std::move(value))
  {
  }
  Checked(Fault fault) // NOLINT(google-explicit-constructor)
    : Content(std::move(fault))
  {
  }

  explicit operator bool() const noexcept { return this->Content.index() == 0; }
  T& operator*() { return std::get<0>(this->Content); }
  const T& operator*() const { return std::get<0>(this->Content); }
  T* operator->() { return &std::get<0>(this->Content); }
  const T* operator->() const { return &std::get<0>(this->Content); }
  /// Returns the reason why there is no value; "" if there is a value.
  std::string fault() const { return *this ? std::string() : std::get<1>(this->Content).text; }

private:
  std::variant<T, Fault> Content;
};

/// Runs the steps in order until one returns a fault. Returns this fault, or "" if there is none.
template <class... Steps>
std::string firstFault(const Steps&... steps)
{
  std::string fault;
  const auto isFine = [&fault](const auto& step)
  {
    fault = step();
    return fault.empty();
  };
  static_cast<void>((isFine(steps) && ...));
  return fault;
}

/// Returns the fault preceded by `words`; "" if there is no fault.
inline std::string prefixed(const char* words, const std::string& fault)
{
  if (fault.empty())
  {
    return {};
  }
  return words + fault;
}
} // namespace palpate

#endif
