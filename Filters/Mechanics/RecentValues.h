// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RecentValues_h
#define palpate_RecentValues_h

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

namespace palpate
{
/// A cache of results that take long to compute. A result is found by its complete input, the key.
/// The cache keeps the most recently used results, up to a maximum number and a maximum total of
/// bytes. Thread-safe. Keys are compared one by one, which is suitable for some tens of values.
template <class Key, class Value>
class RecentValues
{
public:
  RecentValues(std::size_t mostValues, std::size_t mostBytes)
    : MostValues(mostValues)
    , MostBytes(mostBytes)
  {
  }

  /// Returns the value of a key; null if there is none.
  std::shared_ptr<const Value> find(const Key& key)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = std::find_if(
      this->All.begin(), this->All.end(), [&key](const Entry& one) { return one.key == key; });
    if (found == this->All.end())
    {
      return nullptr;
    }
    this->All.splice(this->All.begin(), this->All, found);
    return this->All.front().value;
  }

  /// Stores a value with the size `bytes`. Removes the least recently used values if necessary.
  void keep(const Key& key, std::shared_ptr<const Value> value, std::size_t bytes)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->All.push_front({ key, std::move(value), bytes });
    std::size_t sum = 0;
    const auto last = std::find_if(this->All.begin(), this->All.end(),
      [&](const Entry& one) { return (sum += one.bytes) > this->MostBytes; });
    this->All.erase(last, this->All.end());
    if (this->All.size() > this->MostValues)
    {
      this->All.pop_back();
    }
  }

  /// Returns the value of a key. If there is none, calls make(), which returns the value and its
  /// size, and stores the value. Two threads with the same key may both call make() at the same
  /// time.
  template <class Make>
  std::shared_ptr<const Value> get(const Key& key, const Make& make)
  {
    std::shared_ptr<const Value> value = this->find(key);
    if (!value)
    {
      std::size_t bytes = 0;
      std::tie(value, bytes) = make();
      this->keep(key, value, bytes);
    }
    return value;
  }

private:
  struct Entry
  {
    Key key;
    std::shared_ptr<const Value> value;
    std::size_t bytes;
  };
  std::size_t MostValues;
  std::size_t MostBytes;
  std::mutex Mutex;
  std::list<Entry> All; ///< entries in the order of last use, the most recent first
};
} // namespace palpate

#endif
