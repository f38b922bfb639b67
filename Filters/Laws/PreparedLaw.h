// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PreparedLaw_h
#define palpate_PreparedLaw_h

#include "Laws/LocalContact.h"
#include "Laws/ResponseLaw.h"
#include "Mechanics/PalpateExport.h"

#include <memory>

namespace palpate
{
class AxisymmetricTool;
class MaterialRange;
class StrainCorrection;

/// A tool's law, and its local contact with curvature and finite strain; null: the textbook's law.
struct PreparedLaw
{
  ResponseLaw law;
  std::shared_ptr<const LocalContact> contact;
};

/// The law of `tool` to a depth of `range` (mm) in `samples` samples, ready for all bodies within
/// `bounds`, with a local contact or without. `tool` and `strain` (null: small strain) must outlive
/// it. Cost: tables of layers, if there are any, 10 ms to a second.
PALPATE_EXPORT PreparedLaw prepareLaw(const AxisymmetricTool& tool, double range, int samples,
  const MaterialRange& bounds, bool hasContact, const StrainCorrection* strain);
} // namespace palpate

#endif
