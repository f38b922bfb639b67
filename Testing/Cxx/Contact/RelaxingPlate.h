// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_testing_RelaxingPlate_h
#define palpate_testing_RelaxingPlate_h

#include "Contact/ContactBody.h"
#include "Contact/ToolContact.h"
#include "SampleBodies.h"
#include "SampleResponses.h"
#include "SampleSeries.h"

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace palpate::testing
{
/// A plate at z = 0, 60 mm wide, that relaxes. Its slow response is factor · δ^exponent (N, mm),
/// optionally with another factor at each point. This object owns the memory of the arrays.
struct RelaxingPlate
{
  explicit RelaxingPlate(double exponent, const PronySeries& series, double range = 1.0,
    const std::function<double(const Vector3&)>& factor = {})
    : surface(openPlate(60.0, 12))
    , store(surface.points.size())
    , curveExponent(exponent)
  {
    constexpr std::size_t samples = 8;
    for (std::size_t p = 0; p < this->surface.points.size(); ++p)
    {
      const double scale = factor ? factor(this->surface.points[p]) : 1.0;
      this->store.range[p] = static_cast<float>(range);
      for (std::size_t i = 0; i < samples; ++i)
      {
        const double s = static_cast<double>(i + 1) / samples;
        const double depth = range * s * s;
        this->store.force[samples * p + i] = static_cast<float>(scale * std::pow(depth, exponent));
        this->store.stiffness[samples * p + i] =
          static_cast<float>(scale * exponent * std::pow(depth, exponent - 1.0));
      }
    }
    this->terms.series = series;
    this->terms.exponent = exponent;
  }

  std::unique_ptr<ContactBody> body() const
  {
    ResponseArrays arrays = this->store.arrays();
    arrays.exponent = this->curveExponent;
    arrays.relaxation = this->terms;
    return contactBody(this->surface, arrays);
  }

  Surface surface;
  ResponseStore store;
  RelaxationTerms terms;
  double curveExponent;
};

/// A tip that is not near edges and corners of the plate's triangles.
inline Vector3 tipAt(double depth, double x = 31.3, double y = 29.1)
{
  return { x, y, -depth };
}
} // namespace palpate::testing

#endif
