// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FileMesh_h
#define palpate_FileMesh_h

#include <cstdint>
#include <string>
#include <vector>

namespace palpate
{
/// The polygons of a mesh file, or what is wrong with it. A file that is wrong gives no polygons.
struct FileMesh
{
  std::vector<float> points;         ///< x, y, z of each, finite
  std::vector<float> normals;        ///< x, y, z of each point; empty if the file has none to use
  std::vector<std::int64_t> corners; ///< numbers of points, polygon after polygon
  std::vector<std::int64_t> starts;  ///< of each polygon in `corners`, and the end of the last one
  std::vector<std::string> notes;    ///< what was left out, a part of a sentence each
  std::string fault;                 ///< names the line or the facet; "": nothing is wrong
};
} // namespace palpate

#endif
