// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrainCache_h
#define StrainCache_h

#include <cstddef>
#include <string>
#include <vector>

namespace palpate
{
/**
 * A cache of solutions by their problem: text files in $PALPATE_CACHE, or $XDG_CACHE_HOME/palpate,
 * or ~/.cache/palpate, whose first line is the key. Written whole or not at all; a file that cannot
 * be read or written, or has another key, is ignored. With PALPATE_CACHE empty nothing is kept.
 */
std::vector<double> readStrainCache(const std::string& key, std::size_t count);
void writeStrainCache(const std::string& key, const std::vector<double>& values);
} // namespace palpate

#endif
