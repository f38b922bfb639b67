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
/// A body with its responses, which take minutes to compute, from the cache in `file`; null if
/// there is none, or one that cannot be read or lacks one of the named point arrays.
vtkSmartPointer<vtkPolyData> readSolved(
  const std::string& file, const std::vector<std::string>& pointArrays);

/// Writes it to the cache; without a `file` does nothing. Returns what is wrong, or "".
std::string keepSolved(vtkPolyData* body, const std::string& file);

/// For the key of a cache: material, tools, depth and tolerance of a scene's responses.
std::string solvedKey(const ViewerOptions& options, const ViewerScene& scene);

/// The content of a body for the key of a cache: points, triangles and point arrays.
std::string contentOf(vtkPolyData* body);
} // namespace palpate

#endif
