// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceProbe_h
#define PieceProbe_h

#include "Pieces/BodyPiece.h"
#include "Response/Pieces/LoadedPieces.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * Presses tips, which may be on any rank, into a body whose pieces are on several ranks. Each rank
 * gathers the part of the body around its own tips. The kernel for a single rank then runs on this
 * part.
 *
 * The kernel reads triangles that are no farther from a tip than the nearest triangle or the last
 * contact, and a few rings of neighbours around these triangles. It also reads the bounding box of
 * the body, which defines its frame. Therefore the part consists of all triangles in a ball around
 * each tip, whose radius is increased by a few times the length of the longest edge, and of
 * triangles that touch the box. The computed distances show afterwards whether a ball was large
 * enough. If it was not, for example for a contact in a thin body, a larger part is gathered.
 * Therefore the result equals that of the whole body, except for the order in which normals around
 * a point are summed. The search on smooth patches has no bound on the distance of the triangles
 * that it reads. A wider margin is used for this search.
 *
 * Memory: each rank stores the parts around its own tips. In the worst case, with tips all over the
 * body or triangles as long as the body, each rank stores the whole body. All calls are collective.
 */
class PieceProbe
{
public:
  /// `piece` must have the response `name`, or be empty.
  PieceProbe(const Ranks& ranks, const BodyPiece& piece, const std::string& name);

  /// Computes the contacts of the tips of this rank. Returns "" or an error message, the same on
  /// all ranks.
  std::string touch(const PressedTips& pressed, std::vector<PieceTouch>& touched);

  /// Returns a description of the defects of the mesh around the tips of this rank
  /// (describeDefects).
  const std::string& defects() const noexcept { return this->Defects; }

private:
  std::vector<TipBall> firstBalls(vtkPolyData* tips, double indentation) const;
  std::string touchPart(const std::vector<TipBall>& balls, double margin,
    const PressedTips& pressed, std::vector<double>& needed, std::vector<PieceTouch>& touched);
  static std::vector<double> neededRadii(
    const ContactBody& body, vtkPolyData* tips, const std::vector<PieceTouch>& touched);

  const Ranks& Among;
  const BodyPiece& Piece;
  std::string Name;
  Eigen::AlignedBox3d Whole;
  double LongestEdge;
  std::string Defects;
};
} // namespace palpate

#endif
