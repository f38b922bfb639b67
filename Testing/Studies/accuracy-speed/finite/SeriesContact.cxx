// SPDX-License-Identifier: BSD-3-Clause
#include "SeriesContact.h"

#include "Mechanics/SeriesCompliance.h"

#include <limits>

namespace palpate::testing
{

SeriesContact::SeriesContact(FiniteBodyPointer body, ToolPointer tool, From from)
  : Body(std::move(body))
  , Tool(std::move(tool))
  , Source(from)
{
  this->Body->globalCompliances();
  if (from == From::Modes)
  {
    this->Body->modes();
  }
}

std::string SeriesContact::name() const
{
  return this->Source == From::Stored ? "local + global" : "local + six modes";
}

std::size_t SeriesContact::bytes() const
{
  const auto nodes = static_cast<std::size_t>(this->Body->windowNodes());
  return sizeof(double) * nodes * (this->Source == From::Stored ? 1 : this->Body->modes().size());
}

double SeriesContact::compliance(double x, double y) const
{
  if (this->Source == From::Stored)
  {
    return this->Body->globalCompliance(x, y);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < this->Body->modes().size(); ++k)
  {
    const double mode = interpolateWindow(*this->Body, this->Body->modes()[k], x, y);
    sum += this->Body->modeSigns()[k] * mode * mode;
  }
  return sum;
}

Vector3 SeriesContact::force(const Vector3& tip)
{
  const SeriesPoint point = seriesResponse(
    *this->Tool, this->Body->scene().reducedModulus, this->compliance(tip.x(), tip.y()), -tip.z());
  return { 0.0, 0.0, point.force };
}

SiteSpring::SiteSpring(FiniteBodyPointer body, Kind kind)
  : Body(std::move(body))
  , Which(kind)
{
  if (kind == Kind::Global)
  {
    this->Compliances = this->Body->globalCompliances();
    return;
  }
  for (int i = 0; i < this->Body->windowNodes(); ++i)
  {
    this->Compliances.push_back(this->Body->compliance()(i, i));
  }
}

std::string SiteSpring::name() const
{
  return this->Which == Kind::Global ? "global compliance only" : "one node pressed";
}

Vector3 SiteSpring::force(const Vector3& tip)
{
  if (!(tip.z() < 0.0))
  {
    return Vector3::Zero();
  }
  const double compliance = interpolateWindow(*this->Body, this->Compliances, tip.x(), tip.y());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return { 0.0, 0.0, compliance > 0.0 ? -tip.z() / compliance : nan };
}

} // namespace palpate::testing
