// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyCache_h
#define palpate_BodyCache_h

#include "BodyFile.h"

#include <string>

namespace palpate
{
/// Path of the file for `key` in $XDG_CACHE_HOME/palpate (or ~/.cache/palpate), named
/// `kind`-HASH`ending`; "" if no cache folder is possible. The program's version is part of the
/// hashed key.
std::string cachePlace(const std::string& kind, const std::string& key, const std::string& ending);

/// Makes the folder of a cache file. Returns "" or an error.
std::string makeCacheFolder(const std::string& file);

/**
 * Reads a body file as readBodyFile does, but with a cache, for scans, whose skin takes seconds to
 * compute. The cache is a flat body file in $XDG_CACHE_HOME/palpate (or ~/.cache/palpate). Its name
 * depends on the path, size and modification time of the scan and on the options. The body has the
 * same bits with and without the cache, including LayerThickness and its error. A cache that cannot
 * be read or written is not an error; a note reports it.
 */
BodyFileResult readCachedScan(const std::string& path, const BodyFileOptions& options);
} // namespace palpate

#endif
