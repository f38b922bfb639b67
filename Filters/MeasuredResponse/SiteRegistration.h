// SPDX-License-Identifier: BSD-3-Clause
#ifndef SiteRegistration_h
#define SiteRegistration_h

#include <Eigen/Geometry>

#include <cstddef>
#include <string>

namespace palpate
{
/// The rigid motion from the frame of the instrument to the frame of the body, mm.
struct SiteRegistration
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  std::size_t pairs = 0;        ///< number of pairs of points; 0 if the motion is given as a matrix
  double residual = 0.0;        ///< root mean square over the pairs, mm
  double largestResidual = 0.0; ///< mm
};

/**
 * Reads a registration from a file of one of two kinds:
 * - a matrix: 4 rows of 4 numbers, separated by blanks or commas. The last row is 0 0 0 1. The
 *   matrix must be rigid to 1e-3: rows of unit length, at right angles, right-handed;
 * - pairs of points: a CSV with the columns from_x_mm,from_y_mm,from_z_mm,to_x_mm,to_y_mm,to_z_mm,
 *   with at least three points that are not in line. The motion is that of a rigid
 *   vtkLandmarkTransform (Horn 1987).
 *
 * Returns an error message with file and line, or "".
 */
std::string readRegistration(const std::string& path, SiteRegistration& registration);
} // namespace palpate

#endif
