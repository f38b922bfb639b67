// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactBody_h
#define palpate_ContactBody_h

#include "BodyMesh.h"
#include "ResponseField.h"
#include "TriangleTree.h"

#include <utility>

namespace palpate
{
/// All a tick needs of a body: its surface, the search tree over it, the response at its points.
/// Immutable once built; shared by any number of ToolContacts. The response covers every point.
struct ContactBody
{
  ContactBody(BodyMesh mesh, ResponseField responses)
    : surface(std::move(mesh))
    , tree(surface)
    , response(std::move(responses))
  {
  }
  ContactBody(const ContactBody&) = delete;
  ContactBody& operator=(const ContactBody&) = delete;

  const BodyMesh surface;
  const TriangleTree tree;
  const ResponseField response;
};
} // namespace palpate

#endif
