// SPDX-License-Identifier: BSD-3-Clause
#include "NodalContact.h"

#include "Mechanics/SeriesCompliance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::testing
{
namespace
{
/// Fraction of the depth by which the surface next to the contact may rise. Nodes within this
/// height are candidates for contact.
constexpr double Rise = 0.25;
} // namespace

NodalContact::NodalContact(FiniteBodyPointer body, ToolPointer tool)
  : Body(std::move(body))
  , Tool(std::move(tool))
{
  this->Body->globalCompliances();
}

void NodalContact::collect(const Vector3& tip, double depth)
{
  const FiniteBody& body = *this->Body;
  double reach = body.mesh().spacing;
  while (reach < 4.0 * body.mesh().window && this->Tool->profile(reach) < (1.0 + Rise) * depth)
  {
    reach += body.mesh().spacing;
  }
  const auto index = [&body](double at)
  {
    const double i = std::floor((at + body.mesh().window) / body.mesh().spacing);
    return static_cast<int>(std::clamp(i, 0.0, static_cast<double>(body.side() - 1)));
  };
  this->Candidates.clear();
  std::vector<double> wanted;
  for (int row = index(tip.y() - reach); row <= index(tip.y() + reach); ++row)
  {
    for (int column = index(tip.x() - reach); column <= index(tip.x() + reach); ++column)
    {
      const double r =
        std::hypot(body.coordinate(column) - tip.x(), body.coordinate(row) - tip.y());
      const double motion = depth - this->Tool->profile(r);
      if (motion > -Rise * depth)
      {
        this->Candidates.push_back(row * body.side() + column);
        wanted.push_back(motion);
      }
    }
  }
  this->Wanted =
    Eigen::Map<Eigen::VectorXd>(wanted.data(), static_cast<Eigen::Index>(wanted.size()));
}

void NodalContact::guess(const Vector3& tip, double depth)
{
  const FiniteBody& body = *this->Body;
  double radius = 0.0;
  if (this->Touched.empty())
  {
    const double modulus = body.scene().reducedModulus;
    const double compliance = body.globalCompliance(tip.x(), tip.y());
    const SeriesPoint point = seriesResponse(*this->Tool, modulus, compliance, depth);
    radius = this->Tool->contactRadius(point.stable ? point.localDeflection : depth);
  }
  this->Active.clear();
  for (std::size_t i = 0; i < this->Candidates.size(); ++i)
  {
    const int node = this->Candidates[i];
    const bool in = this->Touched.empty()
      ? (body.position(node) - tip.head<2>()).norm() <= radius
      : std::binary_search(this->Touched.begin(), this->Touched.end(), node);
    if (in)
    {
      this->Active.push_back(static_cast<int>(i));
    }
  }
}

Vector3 NodalContact::force(const Vector3& tip)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const double depth = -tip.z();
  if (!(depth > 0.0))
  {
    this->Touched.clear();
    return Vector3::Zero();
  }
  this->collect(tip, depth);
  this->guess(tip, depth);
  if (!this->Contact.solve(*this, this->Wanted, this->Active, this->Forces))
  {
    this->Touched.clear();
    return { nan, nan, nan };
  }
  this->Touched.clear();
  const int last = this->Body->side() - 1;
  bool inside = true;
  for (const int i : this->Active)
  {
    const int node = this->Candidates[static_cast<std::size_t>(i)];
    const int column = node % this->Body->side();
    const int row = node / this->Body->side();
    inside = inside && column > 0 && row > 0 && column < last && row < last;
    this->Touched.push_back(node);
  }
  const double beyond = this->Body->mesh().window;
  if (!inside || std::abs(tip.x()) > beyond || std::abs(tip.y()) > beyond)
  {
    return { nan, nan, nan };
  }
  return { 0.0, 0.0, this->Forces.sum() };
}

} // namespace palpate::testing
