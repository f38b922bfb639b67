// SPDX-License-Identifier: BSD-3-Clause
#ifndef BodyPiece_h
#define BodyPiece_h

#include "Response/Pieces/BodySeam.h"
#include "Contact/TriangleProjection.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;
class vtkStaticPointLocator;

namespace palpate
{
/// A ball around a tip, mm.
struct TipBall
{
  double centre[3];
  double radius;
};

/**
 * The piece of a body on this rank. cut() returns the triangles of the piece around given tips.
 *
 * Points and triangles with a coordinate that is not finite are ignored. Construction takes O(n)
 * for n points and is not collective, because the seam is an argument. The body must not change
 * during the lifetime of this object.
 */
class BodyPiece
{
public:
  /// Name of an array that cut() adds to the arrays of the response. It has one int per point, the
  /// index of the point on the seam, or -1 if the point is not on the seam.
  static constexpr const char* SeamArray = "PalpateSeam";
  /// Name of an array that cut() adds. It has one int per triangle, the id of the cell in the
  /// piece.
  static constexpr const char* CellArray = "PalpateCell";

  /// `body` must have passed checkTriangles, or be empty.
  BodyPiece(vtkPolyData* body, const BodySeam& seam);
  ~BodyPiece();

  /// Returns the distance from a tip to the nearest corner of a triangle, mm. It is infinite if
  /// there is no triangle.
  double nearest(const Vector3& tip) const;
  /// Length of the longest edge, mm; 0 without triangles.
  double longestEdge() const noexcept { return this->LongestEdge; }
  const Eigen::AlignedBox3d& box() const noexcept { return this->Box; }

  /**
   * Returns the triangles that have a corner in one of the balls. The radii of the balls are
   * increased by `margin` (mm). `whole` is the bounding box of all pieces. For each face of `whole`
   * that this piece touches, a triangle that touches this face is added. Therefore the cuts of all
   * ranks together have the box `whole`. The result has the arrays of the response `name`,
   * SeamArray and CellArray.
   */
  vtkSmartPointer<vtkPolyData> cut(const std::vector<TipBall>& balls, double margin,
    const Eigen::AlignedBox3d& whole, const std::string& name) const;

private:
  Vector3 point(std::int32_t id) const
  {
    return Eigen::Map<const Vector3>(this->Points.data() + 3 * static_cast<std::size_t>(id));
  }
  std::vector<char> markPoints(const std::vector<TipBall>& balls, double margin) const;
  void keepExtremes(const Eigen::AlignedBox3d& whole, std::vector<char>& kept) const;

  vtkSmartPointer<vtkPolyData> Body;
  std::vector<double> Points;
  std::vector<std::int32_t> Triangles; ///< three point ids for each triangle
  std::vector<char> Finite;            ///< whether the coordinates of each triangle are finite
  /// Index of each point on the seam; -1 if the point is not on the seam.
  std::vector<std::int32_t> Seam;
  Eigen::AlignedBox3d Box;
  double LongestEdge = 0.0;
  vtkSmartPointer<vtkPolyData> Used; ///< The points that belong to triangles.
  std::vector<std::int32_t> UsedIds;
  vtkNew<vtkStaticPointLocator> Locator; ///< locator for the points of Used
};
} // namespace palpate

#endif
