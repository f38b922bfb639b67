// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FileMesh_h
#define palpate_FileMesh_h

#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// The polygons of a mesh file, or its fault. If there is a fault, there are no polygons.
struct FileMesh
{
  std::vector<float> points;         ///< x, y, z of each, finite
  std::vector<float> normals;        ///< x, y, z of each point; empty if none are usable
  std::vector<std::int64_t> corners; ///< indices of points, polygon after polygon
  /// Index in `corners` of the start of each polygon, and of the end of the last one.
  std::vector<std::int64_t> starts;
  std::vector<std::string> notes; ///< the omitted parts, each as a part of a sentence
  std::string fault;              ///< names the line or the facet; "": no fault
};
} // namespace palpate

#endif
