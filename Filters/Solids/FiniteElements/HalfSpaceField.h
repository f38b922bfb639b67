// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_HalfSpaceField_h
#define palpate_HalfSpaceField_h

#include <Eigen/Core>

namespace palpate
{
/**
 * Displacement of a half-space z >= 0 of Young's modulus 1 MPa under a normal force of 1 N at the
 * origin of its surface, pressing along +z (Boussinesq 1885; Johnson 1985, eq. 3.18). `at` in mm,
 * the result in mm; divide by E for another modulus. Above the surface the value of the surface
 * below; infinite at the origin.
 */
Eigen::Vector3d boussinesqDisplacement(const Eigen::Vector3d& at, double poissonRatio);
} // namespace palpate

#endif
