// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_MeshRequirements_h
#define palpate_testing_MeshRequirements_h

#include "Contact/MeshFiles/FileMesh.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace palpate::testing
{
/// Checks a mesh from a file. A mesh with a fault must be empty. Otherwise each corner must be a
/// valid point.
inline void requireWhole(const FileMesh& mesh)
{
  if (!mesh.fault.empty())
  {
    require(mesh.points.empty() && mesh.corners.empty(), "after a fault nothing is half loaded");
    return;
  }
  const auto points = static_cast<std::int64_t>(mesh.points.size() / 3);
  require(mesh.points.size() % 3 == 0, "a point has three coordinates");
  require(mesh.normals.empty() || mesh.normals.size() == mesh.points.size(),
    "each point has a normal, or none");
  require(std::all_of(mesh.points.begin(), mesh.points.end(),
            [](float value) { return std::isfinite(value); }),
    "coordinates are finite");
  require(std::all_of(mesh.corners.begin(), mesh.corners.end(),
            [points](std::int64_t corner) { return corner >= 0 && corner < points; }),
    "a corner is a point that is there");
  require(!mesh.starts.empty() && mesh.starts.front() == 0 &&
      mesh.starts.back() == static_cast<std::int64_t>(mesh.corners.size()),
    "polygons begin at the first corner and end at the last");
  for (std::size_t i = 1; i < mesh.starts.size(); ++i)
  {
    require(mesh.starts[i] >= mesh.starts[i - 1] + 3, "a polygon has three corners");
  }
}
} // namespace palpate::testing

#endif
