// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_Wrench_h
#define palpate_Wrench_h

#include <Eigen/Core>

namespace palpate
{
/// A force and a torque about the tool's tip, on the hand. The device's frame; N, N m.
struct Wrench
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
};
} // namespace palpate

#endif
