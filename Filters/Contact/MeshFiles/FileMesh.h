// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FileMesh_h
#define palpate_FileMesh_h

#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// The polygons of a mesh file, or an error message. If there is an error, there are no polygons.
struct FileMesh
{
  std::vector<float> points;  ///< x, y, z of each point; all values are finite
  std::vector<float> normals; ///< x, y, z for each point; empty if the file has no usable normals
  std::vector<std::int64_t> corners; ///< point indices of the corners, polygon after polygon
  /// Index in `corners` of the start of each polygon, and of the end of the last one.
  std::vector<std::int64_t> starts;
  /// The omitted contents of the file, each as a part of a sentence.
  std::vector<std::string> notes;
  std::string fault; ///< message that names the line or the facet; "" if there is no fault
};
} // namespace palpate

#endif
