// SPDX-License-Identifier: BSD-3-Clause
#include "RelaxationPreset.h"

namespace palpate
{
namespace
{
using Branches = std::vector<std::array<double, 2>>;

const std::array<Branches, 4>& relaxations()
{
  static const std::array<Branches, 4> Published = { {
    {}, // no branches for Custom, not used
    // Wang et al. 2015, PLoS ONE 10(3):e0120897, mouse skin in compression: residual fraction 0.28
    // +- 0.13, therefore p = 0.72/0.28, and time 0.19 +- 0.10 s.
    { { 2.57, 0.19 } },
    // Zheng and Mak 1999, J. Biomech. Eng. 121:330, indentation of limbs, quasi-linear: alpha 0.029
    // to 0.277, therefore p = alpha/(1 - alpha) is 0.03 to 0.38, and time 0.05 to 8.93 s. The
    // values here are in the middle of both ranges.
    { { 0.15, 1.0 } },
    // An assumption, not a published value. The loops are as narrow as in Mahvash and Hayward 2002.
    { { 0.05, 0.1 }, { 0.05, 3.0 } },
  } };
  return Published;
}
} // namespace

int RelaxationPreset::count()
{
  return static_cast<int>(relaxations().size());
}

void RelaxationPreset::choose(int relaxation)
{
  if (relaxation >= 0 && relaxation < RelaxationPreset::count())
  {
    this->Chosen = relaxation;
  }
}

std::vector<std::array<double, 2>> RelaxationPreset::inForce() const
{
  return this->Chosen == Custom ? this->own : relaxations()[static_cast<std::size_t>(this->Chosen)];
}
} // namespace palpate
