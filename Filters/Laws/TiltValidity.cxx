// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/TiltValidity.h"

#include "Contact/ParallelRanges.h"
#include "Contact/ResponseContract.h"
#include "Laws/TiltedCurves.h"
#include "Laws/TrustedDepth.h"
#include "Mechanics/Tilt/TiltError.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace palpate
{
void limitByTilts(const AxisymmetricTool& tool, const ContactSpots& spots,
  const ResponseArrays& arrays, double tolerance, const TrustSpans& trust)
{
  const TiltedCurves curves(arrays);
  const TiltTerms& terms = arrays.tilt.terms;
  const double drop = curves.table().deepest(terms.largest).drop;
  const auto errorAt = [&](std::size_t i, double thickness, double depth)
  {
    const double upright = curves.upright().evaluate(static_cast<std::int32_t>(i), depth).force;
    const double tilted = curves.at(i, depth, terms.largest).force;
    return tiltError({ thickness > 0.0 ? tool.contactRadius(depth) / thickness : 0.0,
      upright > 0.0 ? tilted / upright : 1.0, terms.dropScale * drop / depth });
  };
  const auto samples = static_cast<std::size_t>(arrays.samples);
  const auto limit = [&](std::size_t i)
  {
    const double thickness = spots.at(i).thickness;
    if (!arrays.isUsable(i))
    {
      return;
    }
    const auto range = static_cast<double>(arrays.range[i]);
    TrustedDepth trusted(range, samples, tolerance);
    for (std::size_t k = samples; k > 0; --k)
    {
      const double error =
        errorAt(i, thickness, curves.upright().sampling().depth(static_cast<int>(k) - 1, range));
      trusted.add(k, error);
      if (trust.error)
      {
        float& kept = trust.error[samples * i + k - 1];
        kept = std::max(kept, static_cast<float>(error));
      }
    }
    // At first contact the contact radius is much smaller than the thickness of the layer.
    trusted.add(0, 0.0);
    const auto depth = static_cast<float>(trusted.depth());
    if (depth < trust.validity[i])
    {
      trust.validity[i] = depth;
      trust.limit[i] = static_cast<unsigned char>(ResponseLimit::Tilt);
    }
  };
  forRanges(arrays.points,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        limit(i);
      }
    });
}
} // namespace palpate
