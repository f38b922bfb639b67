// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/PreparedLaw.h"

#include "Laws/MaterialRange.h"

namespace palpate
{
PreparedLaw prepareLaw(const AxisymmetricTool& tool, double range, int samples,
  const MaterialRange& bounds, bool hasContact, const StrainCorrection* strain)
{
  PreparedLaw made{ ResponseLaw(tool, range, samples), nullptr };
  const LayerTable::Layers layers = bounds.hasLayers() ? bounds.prepared() : LayerTable::Layers();
  if (hasContact)
  {
    auto contact = std::make_shared<LocalContact>(tool, range, bounds.stiffens, strain);
    if (bounds.hasLayers())
    {
      contact->prepareLayers(layers);
    }
    made.law.correct(contact);
    made.contact = std::move(contact);
  }
  if (bounds.hasLayers())
  {
    made.law.prepareLayers(layers, bounds.stiffens);
  }
  return made;
}
} // namespace palpate
