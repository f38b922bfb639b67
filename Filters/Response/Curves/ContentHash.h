// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContentHash_h
#define ContentHash_h

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace palpate
{
/// Returns a hash of the bytes of numbers. Caches use it to recognise a body by its content.
template <class Value>
std::size_t hashOf(const std::vector<Value>& values)
{
  const std::string_view bytes(
    reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  return std::hash<std::string_view>()(bytes);
}
} // namespace palpate

#endif
