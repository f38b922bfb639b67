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
/// A body with its responses that took minutes to solve for, as the cache has it in `file`; null
/// where there is none, or one that cannot be read or lacks a point array that is named.
vtkSmartPointer<vtkPolyData> readSolved(
  const std::string& file, const std::vector<std::string>& pointArrays);

/// Keeps it for the next time; without a `file` nothing is kept. What is wrong, or "".
std::string keepSolved(vtkPolyData* body, const std::string& file);

/// For the key of a cache: material, tools, depth and tolerance of a scene's responses.
std::string solvedKey(const ViewerOptions& options, const ViewerScene& scene);

/// What tells one body from another, for the key of a cache: points, triangles and point arrays.
std::string contentOf(vtkPolyData* body);
} // namespace palpate

#endif
