// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SolvedCache_h
#define palpate_SolvedCache_h

#include "ViewerScene.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// Reads a body from the cache file `file`. The body has responses that take minutes to compute.
/// Returns null if the file does not exist, cannot be read, or lacks one of the given point arrays.
vtkSmartPointer<vtkPolyData> readSolved(
  const std::string& file, const std::vector<std::string>& pointArrays);

/// Writes the body to the cache. Has no effect if `file` is empty. Returns "" or an error.
std::string keepSolved(vtkPolyData* body, const std::string& file);

/// Returns a part of a cache key, with material, tools, depth and tolerance of a scene's responses.
std::string solvedKey(const ViewerOptions& options, const ViewerScene& scene);

/// Returns a part of a cache key that depends on points, triangles and point arrays of a body.
std::string contentOf(vtkPolyData* body);
} // namespace palpate

#endif
