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
 * Presses a tool at places of a body. For each place, a part of the body around the place is cut
 * out and filled with cells that are fine under the tool. The motion of the surrounding body is
 * that of its coarse cells. Thread-safe.
 *
 * The part extends five contact radii from the place. On a half-space, the body beyond this
 * distance contributes an eighth of the compliance, and the error of coarse cells is a few
 * hundredths of this contribution. The part is enlarged to eight contact radii if the results of
 * the two meshes differ too much, or if the tool extends beyond the part.
 */
class DirectPresses
{
public:
  /// The surface, the bodies and the tool must outlive this object. `coarser` is `body` with longer
  /// cells. `terms` contains the tool, the material, the depth, and whether finite strain is
  /// solved.
  DirectPresses(const PreparedSurface& surface, const RestOfBody& body, const RestOfBody& coarser,
    const DirectTerms& terms);

  struct Contacts
  {
    DirectPress finer;
    DirectPress coarser; ///< the contact with cells that are 1.5 times as long
  };
  /// Presses the tool at a place. Returns "" or an error message for this place.
  std::string at(const DirectPlace& place, Contacts& contacts) const;

private:
  /// The part on which the tool is pressed.
  struct Part
  {
    ElasticBody body;
    UnitMotion moved;                 ///< motion due to the surrounding body, under unit loads
    std::vector<unsigned char> onCut; ///< for each node: whether the node is on the cut
    std::vector<unsigned char> held;
  };
  /// Factors on the lengths of the cells. They are 1 for the finest mesh.
  struct Lengths
  {
    double near = 1.0;
    double far = 1.0;
  };
  PartCells cells(const DirectPlace& place, const Lengths& lengths) const;
  std::string make(const DirectPlace& place, const CutOutSurface& cut, const Lengths& lengths,
    const RestOfBody& rest, Part& part) const;
  /// Presses in a box that is `wider` times as large as the default box, with the same number of
  /// cells. If the surface cannot be cut at this box, the next larger box that can be cut is used.
  /// `isBeyond` is set to whether the tool reaches the cut.
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
