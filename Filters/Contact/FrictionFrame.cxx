// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/FrictionFrame.h"

#include <Eigen/Geometry>

namespace palpate
{
void FrictionFrame::start(const Vector3& point, const Vector3& normal) noexcept
{
  this->Started = true;
  this->Point = point;
  this->Normal = normal;
  this->First = normal.unitOrthogonal();
  this->Second = normal.cross(this->First);
  this->Step = StraightStep();
}
} // namespace palpate
