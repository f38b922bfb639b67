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
 * The piece of a body on this rank. The triangles around given tips can be cut from the piece.
 *
 * Points and triangles with a coordinate that is not finite are ignored. Construction takes O(n)
 * and is not collective, because the seam is given. The body must not change during the lifetime of
 * this object.
 */
class BodyPiece
{
public:
  /// Names of the arrays that cut() adds to those of the response.
  static constexpr const char* SeamArray = "PalpateSeam"; ///< int per point; -1: not on the seam
  static constexpr const char* CellArray = "PalpateCell"; ///< int per triangle: cell of the piece

  /// `body` must have passed checkTriangles, or be empty.
  BodyPiece(vtkPolyData* body, const BodySeam& seam);
  ~BodyPiece();

  /// Distance from a tip to the nearest corner of a triangle, mm; infinite if there is no triangle.
  double nearest(const Vector3& tip) const;
  double longestEdge() const noexcept { return this->LongestEdge; } ///< mm, 0 without triangles
  const Eigen::AlignedBox3d& box() const noexcept { return this->Box; }

  /**
   * Returns the triangles that have a corner in one of the balls, enlarged by `margin`. For each
   * face of `whole` (the box of all pieces) that this piece reaches, a triangle that reaches this
   * face is added. The cuts of all ranks together therefore have the box `whole`. The cut has the
   * arrays of the response `name`, SeamArray and CellArray.
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
  std::vector<std::int32_t> Triangles; ///< three points for each triangle
  std::vector<char> Finite;            ///< whether each triangle is finite
  std::vector<std::int32_t> Seam;      ///< index of each point on the seam; -1: not on the seam
  Eigen::AlignedBox3d Box;
  double LongestEdge = 0.0;
  vtkSmartPointer<vtkPolyData> Used; ///< the points that triangles use
  std::vector<std::int32_t> UsedIds;
  vtkNew<vtkStaticPointLocator> Locator; ///< locator for the points of Used
};
} // namespace palpate

#endif
