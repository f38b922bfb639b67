// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactBody_h
#define palpate_ContactBody_h

#include "Contact/PackedMesh.h"
#include "Contact/ResponseField.h"
#include "Contact/TriangleTree.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// All a tick needs of a body: its surface, the search tree over it, the response at its points.
/// Immutable once built; shared by any number of ToolContacts. Independent of what it was made of.
struct ContactBody
{
  /// `points` (x, y, z each), `triangles` (three point indices each), and a response for every
  /// point, in the same order.
  ContactBody(const double* points, std::size_t pointCount, const std::int32_t* triangles,
    std::size_t triangleCount, const ResponseArrays& responses, const BuildProgress& progress = {})
    : surface(points, pointCount, triangles, triangleCount, progress)
    , tree(surface)
    , response(responses, &surface)
  {
    if (progress)
    {
      progress(1.0);
    }
  }
  /// The surface of another, copied, under other responses.
  ContactBody(const ContactBody& same, const ResponseArrays& responses)
    : surface(same.surface)
    , tree(same.tree, surface)
    , response(responses, &surface)
  {
  }
  ContactBody(const ContactBody&) = delete;
  ContactBody& operator=(const ContactBody&) = delete;

  const PackedMesh surface;
  const TriangleTree tree;
  const ResponseField response;
};
} // namespace palpate

#endif
