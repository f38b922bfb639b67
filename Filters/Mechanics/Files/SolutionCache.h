// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SolutionCache_h
#define palpate_SolutionCache_h

#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{
/**
 * A cache of solutions in text files. `key` is a text that describes the problem. The files
 * `kind`-HASH.txt are in the folder $PALPATE_CACHE, else $XDG_CACHE_HOME/palpate, else
 * ~/.cache/palpate. The first line of a file is the key. A file is written completely or not at
 * all. readSolution() returns an empty result if the file cannot be read, has another key, or does
 * not have `count` finite values. Failures of writing are ignored. If PALPATE_CACHE is set to an
 * empty text, the cache is off.
 */
PALPATE_EXPORT std::vector<double> readSolution(
  const std::string& kind, const std::string& key, std::size_t count);
PALPATE_EXPORT void writeSolution(
  const std::string& kind, const std::string& key, const std::vector<double>& values);

/// Returns a hash of 16 hexadecimal digits of a text or of the bytes of an array. It is the same in
/// every build.
PALPATE_EXPORT std::string digest(std::string_view text);
} // namespace palpate

#endif
