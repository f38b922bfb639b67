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
/// Around a tip, mm.
struct TipBall
{
  double centre[3];
  double radius;
};

/**
 * The own piece of a body, ready to be cut: which of its triangles lie around given tips.
 *
 * Points and triangles with a coordinate that is not finite are as good as absent. Built in O(n);
 * not collective but for the seam, which is given. The body must not change meanwhile.
 */
class BodyPiece
{
public:
  /// Names of what a cut carries besides the response.
  static constexpr const char* SeamArray = "PalpateSeam"; ///< int per point; -1: not on the seam
  static constexpr const char* CellArray = "PalpateCell"; ///< int per triangle: cell of the piece

  /// `body` has passed checkTriangles, or is empty.
  BodyPiece(vtkPolyData* body, const BodySeam& seam);
  ~BodyPiece();

  /// Distance from a tip to the nearest point of a triangle, mm; infinite if there is none.
  double nearest(const Vector3& tip) const;
  double longestEdge() const noexcept { return this->LongestEdge; } ///< mm, 0 without triangles
  const Eigen::AlignedBox3d& box() const noexcept { return this->Box; }

  /**
   * The triangles with a corner in one of the balls, grown by `margin`; and those that reach the
   * faces of `whole`, the box of all pieces, so that the cuts of all ranks have that box together.
   * With the arrays of the response `name`, SeamArray and CellArray.
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
  std::vector<std::int32_t> Triangles; ///< three points each
  std::vector<char> Finite;            ///< per triangle
  std::vector<std::int32_t> Seam;      ///< per point, -1 elsewhere
  Eigen::AlignedBox3d Box;
  double LongestEdge = 0.0;
  vtkSmartPointer<vtkPolyData> Used; ///< the points of triangles
  std::vector<std::int32_t> UsedIds;
  vtkNew<vtkStaticPointLocator> Locator; ///< of Used
};
} // namespace palpate

#endif
