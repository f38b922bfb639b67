// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HalfSpaceField_h
#define palpate_HalfSpaceField_h

#include <Eigen/Core>

namespace palpate
{
/**
 * Returns the displacement of a half-space z >= 0 with Young's modulus 1 MPa under a normal force
 * of 1 N along +z at the origin of its surface (Boussinesq 1885; Johnson 1985, eq. 3.18). `at` and
 * the result are in mm. For another modulus, the result must be divided by E. If `at` is above the
 * surface, the result is that of the surface point below `at`. The displacement is infinite at the
 * origin.
 */
Eigen::Vector3d boussinesqDisplacement(const Eigen::Vector3d& at, double poissonRatio);
} // namespace palpate

#endif
