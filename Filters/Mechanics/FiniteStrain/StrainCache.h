// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrainCache_h
#define StrainCache_h

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/**
 * What was solved for before, by what it was solved for: text files in $PALPATE_CACHE, or
 * $XDG_CACHE_HOME/palpate, or ~/.cache/palpate, whose first line is the key. Written whole or not
 * at all; one that cannot be read or written, or is of another key, is as if there were none. With
 * PALPATE_CACHE empty nothing is kept.
 */
std::vector<double> readStrainCache(const std::string& key, std::size_t count);
void writeStrainCache(const std::string& key, const std::vector<double>& values);
} // namespace palpate

#endif
