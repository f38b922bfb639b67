// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Numerics/UnilateralContact.h"

namespace palpate
{
namespace
{
constexpr int StepsAtOnce = 30;
constexpr int MostSteps = 2000;
/// Smallest gap relative to the largest wanted displacement. A smaller value is a rounding error.
constexpr double Rounding = 1e-9;
} // namespace

bool UnilateralContact::solve(CompliantNodes& nodes, const Eigen::VectorXd& wanted,
  std::vector<int>& active, Eigen::VectorXd& forces)
{
  const double deepest = wanted.size() > 0 ? wanted.maxCoeff() : 0.0;
  const double tolerance = Rounding * deepest;
  forces.setZero(wanted.size());
  if (!(deepest > 0.0))
  {
    active.clear();
    return true;
  }
  for (this->Steps = 1; this->Steps <= MostSteps; ++this->Steps)
  {
    const bool all = this->Steps <= StepsAtOnce;
    nodes.press(active, wanted, forces);
    nodes.move(active, forces, this->Moved);
    this->Touching.assign(static_cast<std::size_t>(wanted.size()), 0);
    int worst = -1;
    double most = 0.0;
    bool settled = true;
    for (const int i : active)
    {
      this->Touching[static_cast<std::size_t>(i)] = 1;
    }
    // Forces are converted to displacements, so that they can be compared with gaps.
    const double perForce =
      forces.cwiseAbs().maxCoeff() > 0.0 ? deepest / forces.cwiseAbs().maxCoeff() : 0.0;
    for (int i = 0; i < wanted.size(); ++i)
    {
      unsigned char& touching = this->Touching[static_cast<std::size_t>(i)];
      const double wrong = touching ? -forces[i] * perForce : wanted[i] - this->Moved[i];
      if (!(wrong > tolerance))
      {
        continue;
      }
      settled = false;
      if (all)
      {
        touching = touching ? 0 : 1;
      }
      else if (wrong > most)
      {
        most = wrong;
        worst = i;
      }
    }
    if (settled)
    {
      return true;
    }
    if (worst >= 0)
    {
      unsigned char& touching = this->Touching[static_cast<std::size_t>(worst)];
      touching = touching ? 0 : 1;
    }
    active.clear();
    for (int i = 0; i < wanted.size(); ++i)
    {
      if (this->Touching[static_cast<std::size_t>(i)])
      {
        active.push_back(i);
      }
    }
  }
  return false;
}

} // namespace palpate
