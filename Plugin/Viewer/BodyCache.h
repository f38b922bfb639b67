// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyCache_h
#define palpate_BodyCache_h

#include "BodyFile.h"

#include <string>

namespace palpate
{
/// Returns the path of the cache file for `key`: `kind`-HASH`ending` in $XDG_CACHE_HOME/palpate (or
/// ~/.cache/palpate). Returns "" if no cache folder is possible. The hash depends on `key` and on
/// the program's version.
std::string cachePlace(const std::string& kind, const std::string& key, const std::string& ending);

/// Makes the folder of a cache file. Returns "" or an error.
std::string makeCacheFolder(const std::string& file);

/**
 * Reads a body file as readBodyFile does, and caches the skin of a scan, which takes seconds to
 * compute. The cache is a flat body file in $XDG_CACHE_HOME/palpate (or ~/.cache/palpate). Its name
 * depends on the path, size and modification time of the scan and on the options. The body has the
 * same bits with and without the cache, including LayerThickness and its error. A cache that cannot
 * be read or written causes a note, not an error.
 */
BodyFileResult readCachedScan(const std::string& path, const BodyFileOptions& options);
} // namespace palpate

#endif
