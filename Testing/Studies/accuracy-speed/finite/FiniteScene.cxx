// SPDX-License-Identifier: BSD-3-Clause
#include "FiniteScene.h"

namespace palpate::testing
{
namespace
{
constexpr double Rubber = 3.45; // E* of the paper's rubber, MPa
constexpr double Poisson = 0.45;
} // namespace

double FiniteScene::youngsModulus() const
{
  return this->reducedModulus * (1.0 - this->poissonRatio * this->poissonRatio);
}

FiniteScene finitePlate()
{
  return { "plate on edges", { 60.0, 40.0, 6.0 }, Support::Edges, Rubber, Poisson };
}

FiniteScene finiteBlock()
{
  // An infinite layer of that thickness has C_g E* = M₀/(πh) = -0.0013 /mm: 0.8 % of a contact,
  // 1/(2a), of a = 3 mm. The fast growth of the elements makes it stiffer by about the same amount:
  // README.md.
  return { "block", { 800.0, 800.0, 400.0 }, Support::Base, Rubber, Poisson, 1.6 };
}

FiniteScene finiteLayer(double thickness)
{
  return { "bonded layer", { 8.0 * thickness, 8.0 * thickness, thickness }, Support::Base, Rubber,
    Poisson };
}

} // namespace palpate::testing
