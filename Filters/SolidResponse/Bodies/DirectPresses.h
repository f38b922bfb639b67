// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectPresses_h
#define palpate_DirectPresses_h

#include "Solids/Curves/DirectCurve.h"
#include "SolidResponse/Bodies/CutOutPart.h"
#include "SolidResponse/Bodies/RestOfBody.h"

#include <string>

namespace palpate
{
/**
 * Presses a tool at places of a body. For each place a part of the body is cut out around it and
 * filled with cells that are fine under the tool. The surrounding body moves as its coarse cells
 * do. Safe from any number of threads.
 *
 * The part extends five contact radii from the place. On a half-space the body beyond that distance
 * contributes an eighth of the compliance, and the error of coarse cells is a few hundredths of
 * that part. The part is enlarged to eight contact radii if the two meshes differ too much or the
 * tool extends farther.
 */
class DirectPresses
{
public:
  /// The surface, the bodies and the tool must outlive this object. `coarser`: `body` in longer
  /// cells. `terms`: tool, material, depth, and whether finite strain is solved.
  DirectPresses(const PreparedSurface& surface, const RestOfBody& body, const RestOfBody& coarser,
    const DirectTerms& terms);

  struct Contacts
  {
    DirectPress finer;
    DirectPress coarser; ///< the contact on cells 1.5 times as long
  };
  /// Presses the tool at a place. Returns "", or a message about the fault there.
  std::string at(const DirectPlace& place, Contacts& contacts) const;

private:
  /// The part that the tool is pressed on.
  struct Part
  {
    ElasticBody body;
    UnitMotion moved;                 ///< motion due to the surrounding body
    std::vector<unsigned char> onCut; ///< per node: whether it is on the cut
    std::vector<unsigned char> held;
  };
  /// Factors on the lengths of the cells; 1 for the finest mesh.
  struct Lengths
  {
    double near = 1.0;
    double far = 1.0;
  };
  PartCells cells(const DirectPlace& place, const Lengths& lengths) const;
  std::string make(const DirectPlace& place, const CutOutSurface& cut, const Lengths& lengths,
    const RestOfBody& rest, Part& part) const;
  /// Presses in a box that is `wider` times as large as the usual one, with as many cells, or in
  /// the next larger box that can be cut. `isBeyond` is set to whether the tool reaches the cut.
  std::string pressIn(
    double wider, const DirectPlace& place, Contacts& contacts, bool& isBeyond) const;
  DirectPress press(const DirectPlace& place, const Part& part) const;

  const PreparedSurface& Surface;
  const RestOfBody& Body;
  const RestOfBody& Coarser;
  const AxisymmetricTool& Tool;
  DirectTerms Terms;
  double Radius; ///< contact radius on a half-space, mm
};
} // namespace palpate

#endif
