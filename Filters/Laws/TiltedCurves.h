// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_TiltedCurves_h
#define palpate_TiltedCurves_h

#include "Contact/ResponseField.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// The curves of a response with tilt data at each point, for use offline. The servo tick uses
/// ContactTilt instead. Can be used from any number of threads.
class TiltedCurves
{
public:
  /// `arrays` must outlive this object.
  explicit TiltedCurves(const ResponseArrays& arrays)
    : Views(arrays.tilt)
    , Curves(arrays)
    , Table(arrays.tilt.terms, arrays.tilt.drops, arrays.tilt.nodes)
  {
  }

  const ResponseField& upright() const noexcept { return this->Curves; }
  const TiltTable& table() const noexcept { return this->Table; }

  /// Force and torque of a tilted tool.
  struct Felt
  {
    double force = 0.0;  ///< N
    double torque = 0.0; ///< M, torque about the tip, N mm
  };
  /// Evaluates force and torque at a depth > 0 of the tool's deepest point (mm) and a tilt (rad).
  Felt at(std::size_t point, double depth, double angle) const
  {
    std::array<double, TiltTerms::MostLaws> weights{ 1.0 };
    if (this->Views.weight)
    {
      const auto laws = static_cast<std::size_t>(this->Views.terms.laws);
      std::copy_n(this->Views.weight + laws * point, laws, weights.begin());
    }
    const auto place = static_cast<std::int32_t>(point);
    const TiltFactor tau = this->Table.at(depth, angle, weights.data());
    const double work = this->Curves.energy(place, depth);
    const double force = this->Curves.evaluate(place, depth).force * tau.value + work * tau.byDepth;
    return { force, force * this->Table.deepest(angle).offset + work * tau.byAngle };
  }

private:
  TiltViews Views;
  ResponseField Curves;
  TiltTable Table;
};
} // namespace palpate

#endif
