// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_StiffenedBody_h
#define palpate_testing_StiffenedBody_h

#include "Contact/ContactBody.h"
#include "SampleResponses.h"

#include <memory>
#include <vector>

namespace palpate::testing
{
/// The surface with its own point normals and with F = `factor` 10 δ^1.5 N everywhere.
inline std::shared_ptr<const ContactBody> stiffened(const Surface& surface, float factor)
{
  ResponseStore store(surface.points.size());
  takeMeshNormals(store, surface);
  for (std::vector<float>* values : { &store.force, &store.stiffness })
  {
    for (float& value : *values)
    {
      value *= factor;
    }
  }
  return contactBody(surface, store);
}
} // namespace palpate::testing

#endif
