// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/ResponseFiller.h"

#include "Laws/ResponseLaw.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr auto Valid = static_cast<unsigned char>(ResponseStatus::Valid);
} // namespace

ResponseFiller::ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law, double range,
  double bodyWidth, const ResponseSpans& spans)
  : Law(law)
  , Spans(spans)
  , Range(static_cast<float>(range))
  , Rule(tool, law, static_cast<double>(this->Range), bodyWidth)
{
}

void ResponseFiller::fill(std::size_t i, const ContactSpot& spot, double curvature) const
{
  this->Spans.range[i] = this->Range;
  this->Spans.status[i] = this->fillCurve(i, spot, curvature);
  const ValidityRule::Answer trusted = this->Spans.status[i] == Valid
    ? this->Rule.at(spot, curvature)
    : ValidityRule::Answer{ 0.0, ResponseLimit::None };
  this->Spans.validity[i] = static_cast<float>(trusted.depth);
  this->Spans.limit[i] = static_cast<unsigned char>(trusted.limit);
}

/// Returns the status of the point.
unsigned char ResponseFiller::fillCurve(
  std::size_t i, const ContactSpot& spot, double curvature) const
{
  const auto n = static_cast<std::size_t>(this->Spans.samples);
  float* force = this->Spans.force + n * i;
  float* stiffness = this->Spans.stiffness + n * i;
  if (this->Spans.status[i] != Valid || curvature < 0.0)
  {
    std::fill_n(force, n, 0.0F);
    std::fill_n(stiffness, n, 0.0F);
    return this->Spans.status[i] != Valid ? this->Spans.status[i]
                                          : static_cast<unsigned char>(ResponseStatus::Degenerate);
  }
  return static_cast<unsigned char>(this->Law.sample(spot, force, stiffness));
}
} // namespace palpate
