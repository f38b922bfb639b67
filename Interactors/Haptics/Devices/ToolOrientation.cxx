// SPDX-License-Identifier: BSD-3-Clause
#include "Haptics/Devices/ToolOrientation.h"

namespace palpate
{
// Not in the header, because FromTwoVectors compiles a singular value decomposition into every file
// that includes the header.
ToolOrientation orientationAlong(const Eigen::Vector3d& axis) noexcept
{
  const double length = axis.norm();
  if (!(length > 0.0 && std::isfinite(length)))
  {
    return orientationNotTold();
  }
  return ToolOrientation::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis / length);
}
} // namespace palpate
