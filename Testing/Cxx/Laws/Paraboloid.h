// SPDX-License-Identifier: BSD-3-Clause
#ifndef Paraboloid_h
#define Paraboloid_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Tools/ToolSpecification.h"

#include <cmath>
#include <memory>

namespace palpate::testing
{
/// A paraboloid, whose laws are closed forms (Hertz 1882): a = √(R δ), F = 4/3 E* √R δ^1.5.
struct Paraboloid
{
  double radius = 4.0; ///< mm

  std::unique_ptr<AxisymmetricTool> make() const
  {
    return makeTool({ ToolShape::Paraboloid, this->radius });
  }
  double force(double depth, double reducedModulus) const
  {
    return 4.0 / 3.0 * reducedModulus * std::sqrt(this->radius) * std::pow(depth, 1.5);
  }
  double depthAt(double contactRadius) const
  {
    return contactRadius * contactRadius / this->radius;
  }
};
} // namespace palpate::testing

#endif
