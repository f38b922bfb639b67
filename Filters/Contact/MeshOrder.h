// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshOrder_h
#define palpate_MeshOrder_h

#include "Contact/LargePages.h"
#include "Contact/PackedMesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Copies an array with `width` values per point from the order of the input to the order of the
/// mesh's points. The result is empty if `values` is null.
inline LargeVector<float> inMeshOrder(
  const float* values, std::size_t width, const PackedMesh& mesh)
{
  LargeVector<float> ordered;
  if (!values)
  {
    return ordered;
  }
  ordered.resize(width * mesh.pointCount());
  for (std::size_t i = 0; i < mesh.pointCount(); ++i)
  {
    const auto input = static_cast<std::size_t>(mesh.inputPoint(static_cast<std::int32_t>(i)));
    std::copy_n(values + width * input, width, ordered.data() + width * i);
  }
  return ordered;
}
} // namespace palpate

#endif
