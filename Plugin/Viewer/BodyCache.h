// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyCache_h
#define palpate_BodyCache_h

#include "BodyFile.h"

#include <string>

namespace palpate
{
/// The file in $XDG_CACHE_HOME/palpate (or ~/.cache/palpate) for `key`, or "" if there is no place
/// for one: named `kind`-HASH`ending`. The version is part of the key.
std::string cachePlace(const std::string& kind, const std::string& key, const std::string& ending);

/// Makes the folder of such a file. Returns an error, or "".
std::string makeCacheFolder(const std::string& file);

/**
 * readBodyFile for scans, whose skin takes seconds, with a cache: the body as a flat body file in
 * $XDG_CACHE_HOME/palpate (or ~/.cache/palpate), named by path, size and time of the scan and by
 * the options. The body has the same bits whether it was cached or not, LayerThickness included. A
 * cache that cannot be read or written is not an error; a note says so.
 */
BodyFileResult readCachedScan(const std::string& path, const BodyFileOptions& options);
} // namespace palpate

#endif
