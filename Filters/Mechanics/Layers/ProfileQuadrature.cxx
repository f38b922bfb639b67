// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Layers/ProfileQuadrature.h"

namespace palpate
{
namespace
{
// If there are few kinks, they separate curved parts. If there are many kinks, they are the corners
// of a sampled profile, between which g is nearly linear.
int nodesPerPanel(std::size_t kinks)
{
  return kinks <= 4 ? 48 : 8;
}
} // namespace

ProfileQuadrature::ProfileQuadrature(const AxisymmetricTool& tool)
  : Tool(tool)
  , Kinks(tool.kinks())
  , Rule(nodesPerPanel(this->Kinks.size()))
{
  double begin = 0.0;
  for (const double end : this->Kinks)
  {
    for (Eigen::Index i = 0; i < this->Rule.nodes().size(); ++i)
    {
      this->Nodes.push_back(this->nodeOf(begin, end, i));
    }
    begin = end;
  }
}

ProfileQuadrature::Node ProfileQuadrature::nodeOf(double begin, double end, Eigen::Index i) const
{
  const double u = 0.5 * (1.0 + this->Rule.nodes()[i]);
  const double weight = 0.5 * this->Rule.weights()[i] * (end - begin);
  const double x = begin == 0.0 ? end * u : begin + (end - begin) * u * u;
  return { x, begin == 0.0 ? weight : 2.0 * u * weight, this->Tool.reducedProfile(x) };
}
} // namespace palpate
