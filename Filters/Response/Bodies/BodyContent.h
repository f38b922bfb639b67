// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyContent_h
#define BodyContent_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

class vtkPolyData;

namespace palpate
{
/// A hash of the bytes of `count` numbers.
template <class Value>
std::size_t hashOf(const Value* values, std::size_t count)
{
  const std::string_view bytes(reinterpret_cast<const char*>(values), count * sizeof(Value));
  return std::hash<std::string_view>()(bytes);
}

/// The points and triangles of a body as plain numbers, and the hashes with which caches recognize
/// the body. They are made once for all caches of a response.
struct BodyContent
{
  /// The body must have passed checkTriangles; it may have no points.
  explicit BodyContent(vtkPolyData* body);
  BodyContent(std::vector<double> ofPoints, std::vector<std::int32_t> ofTriangles)
    : points(std::move(ofPoints))
    , triangles(std::move(ofTriangles))
    , hash{ hashOf(this->points.data(), this->points.size()),
      hashOf(this->triangles.data(), this->triangles.size()) }
  {
  }

  std::vector<double> points;          ///< x, y, z of each point
  std::vector<std::int32_t> triangles; ///< three point indices each
  std::array<std::size_t, 2> hash;     ///< of points and of triangles
};
} // namespace palpate

#endif
