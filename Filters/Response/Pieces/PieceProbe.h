// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceProbe_h
#define PieceProbe_h

#include "Response/Pieces/BodyPiece.h"
#include "Contact/ContactSettings.h"
#include "Response/Pieces/Ranks.h"
#include "Contact/ToolContact.h"

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
/**
 * Touches a body whose pieces lie on several ranks with tips on any of them: each rank gathers what
 * of the body lies around its own tips, and the one-rank kernel runs on that.
 *
 * The kernel looks only at triangles no farther from a tip than its nearest or its last contact,
 * at those a few corners on (the rings it compares and packs), and at the box of the body for its
 * frame. So the part is: all triangles within a ball around each tip, grown by some longest edges;
 * and those that reach the box. Whether a ball was large enough shows afterwards, by the distances
 * found; if not (a contact followed into a thin body), it is gathered again, larger. The result
 * therefore is that of the whole body, but for the order in which normals around a point are
 * summed. Smooth patches are followed by steps that have no such bound; they get a wider margin.
 *
 * Memory: each rank holds the parts around its own tips: at worst, for tips all over or triangles
 * as long as the body, the whole. All calls are collective.
 */
class PieceProbe
{
public:
  struct Touch
  {
    Vector3 at = Vector3::Zero(); ///< where the tip was after the indentation
    Contact contact;              ///< its triangle: the cell of that rank's piece
    int rank = -1;                ///< that has the touched cell; -1: none
  };

  /// `piece` has the response `name`, or is empty.
  PieceProbe(const Ranks& ranks, const BodyPiece& piece, const std::string& name);

  /// The contacts of the own tips, which have passed checkTips; the same error on all ranks, or "".
  /// Together: they have passed checkCoupledTips, and feel one another.
  std::string touch(vtkPolyData* tips, const ContactSettings& settings, double indentation,
    bool areTogether, std::vector<Touch>& touched);

  /// What is wrong with the mesh around the own tips (describeDefects).
  const std::string& defects() const noexcept { return this->Defects; }

private:
  std::vector<TipBall> firstBalls(vtkPolyData* tips, double indentation) const;
  std::string touchPart(const std::vector<TipBall>& balls, double margin, vtkPolyData* tips,
    const ContactSettings& settings, double indentation, bool areTogether,
    std::vector<double>& needed, std::vector<Touch>& touched);
  static std::vector<double> neededRadii(
    const ContactBody& body, vtkPolyData* tips, const std::vector<Touch>& touched);

  const Ranks& Among;
  const BodyPiece& Piece;
  std::string Name;
  Eigen::AlignedBox3d Whole;
  double LongestEdge;
  std::string Defects;
};
} // namespace palpate

#endif
