// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/TiltValidity.h"

#include "Contact/ParallelRanges.h"
#include "Contact/ResponseContract.h"
#include "Laws/TrustedDepth.h"
#include "Mechanics/Tilt/TiltError.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
namespace
{
/// The errors of one point's samples by the largest tilt.
class TiltedSamples
{
public:
  TiltedSamples(const AxisymmetricTool& tool, const ResponseArrays& arrays)
    : Tool(tool)
    , Arrays(arrays)
    , Field(arrays)
    , Table(arrays.tilt.terms, arrays.tilt.drops, arrays.tilt.nodes)
    , Deepest(this->Table.deepest(arrays.tilt.terms.largest))
  {
  }

  double at(std::size_t point, double thickness, double depth) const
  {
    const TiltTerms& terms = this->Arrays.tilt.terms;
    std::array<double, TiltTerms::MostLaws> weights{ 1.0 };
    if (this->Arrays.tilt.weight)
    {
      const auto laws = static_cast<std::size_t>(terms.laws);
      std::copy_n(this->Arrays.tilt.weight + laws * point, laws, weights.begin());
    }
    const auto place = static_cast<std::int32_t>(point);
    const TiltFactor tau = this->Table.at(depth, terms.largest, weights.data());
    const double upright = this->Field.evaluate(place, depth).force;
    const double tilted = upright * tau.value + this->Field.energy(place, depth) * tau.byDepth;
    return tiltError({ this->Tool.contactRadius(depth) / thickness,
      upright > 0.0 ? tilted / upright : 1.0, terms.dropScale * this->Deepest.drop / depth });
  }
  double depth(std::size_t point, int sample) const
  {
    const auto range = static_cast<double>(this->Arrays.range[point]);
    return this->Field.sampling().depth(sample, range);
  }

private:
  const AxisymmetricTool& Tool;
  const ResponseArrays& Arrays;
  ResponseField Field;
  TiltTable Table;
  DeepestPoint Deepest;
};
} // namespace

void limitByTilts(const AxisymmetricTool& tool, const ContactSpots& spots,
  const ResponseArrays& arrays, double tolerance, const TrustSpans& trust)
{
  const TiltedSamples tilted(tool, arrays);
  const auto samples = static_cast<std::size_t>(arrays.samples);
  const auto limit = [&](std::size_t i)
  {
    const double thickness = spots.at(i).thickness;
    if (!arrays.isUsable(i) || !(thickness > 0.0))
    {
      return;
    }
    const auto range = static_cast<double>(arrays.range[i]);
    TrustedDepth trusted(range, samples, tolerance);
    for (std::size_t k = samples; k > 0; --k)
    {
      const double error = tilted.at(i, thickness, tilted.depth(i, static_cast<int>(k) - 1));
      trusted.add(k, error);
      if (trust.error)
      {
        float& kept = trust.error[samples * i + k - 1];
        kept = std::max(kept, static_cast<float>(error));
      }
    }
    trusted.add(0, 0.0); // of a contact that is small beside its layer
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
