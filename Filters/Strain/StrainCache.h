// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrainCache_h
#define StrainCache_h

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/**
 * A cache of solutions, found by their problem: text files in $PALPATE_CACHE, else
 * $XDG_CACHE_HOME/palpate, else ~/.cache/palpate. The first line of a file is the key. A file is
 * written whole or not at all. A file that cannot be read or written, or has another key, is
 * ignored. With PALPATE_CACHE empty nothing is cached.
 */
std::vector<double> readStrainCache(const std::string& key, std::size_t count);
void writeStrainCache(const std::string& key, const std::vector<double>& values);
} // namespace palpate

#endif
