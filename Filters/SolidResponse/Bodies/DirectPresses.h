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
 * Presses a tool at places of a body. Each place has a part of its own that is cut out around it
 * and has fine cells under the tool. The surrounding body moves as its coarse cells do. Safe from
 * any number of threads.
 *
 * The part extends five contact radii from the place. On a half-space the body beyond it has an
 * eighth of the compliance, and coarse cells miss some hundredths of that. The part is enlarged to
 * eight contact radii if the two meshes differ too much or the tool extends farther.
 */
class DirectPresses
{
public:
  /// The surface, the bodies and the tool must outlive this object. `coarser`: `body` in longer
  /// cells. `terms`: tool, material, depth, and whether at finite strain.
  DirectPresses(const PreparedSurface& surface, const RestOfBody& body, const RestOfBody& coarser,
    const DirectTerms& terms);

  struct Contacts
  {
    DirectPress finer;
    DirectPress coarser; ///< on cells 1.5 times as long
  };
  /// Returns "", or a message about the fault at this place.
  std::string at(const DirectPlace& place, Contacts& contacts) const;

private:
  /// The part that the tool is pressed on.
  struct Part
  {
    ElasticBody body;
    UnitMotion moved;                 ///< motion due to the surrounding body
    std::vector<unsigned char> onCut; ///< per node
    std::vector<unsigned char> held;
  };
  /// Factors on the lengths of the cells; 1 for the finest.
  struct Lengths
  {
    double near = 1.0;
    double far = 1.0;
  };
  PartCells cells(const DirectPlace& place, const Lengths& lengths) const;
  std::string make(const DirectPlace& place, const CutOutSurface& cut, const Lengths& lengths,
    const RestOfBody& rest, Part& part) const;
  /// Presses in a box that is `wider` times as large as the usual one, with as many cells, or in
  /// the next larger box that can be cut. `isBeyond`: the tool reaches the cut.
  std::string pressIn(
    double wider, const DirectPlace& place, Contacts& contacts, bool& isBeyond) const;
  DirectPress press(const DirectPlace& place, const Part& part) const;

  const PreparedSurface& Surface;
  const RestOfBody& Body;
  const RestOfBody& Coarser;
  const AxisymmetricTool& Tool;
  DirectTerms Terms;
  double Radius; ///< of the contact on a half-space, mm
};
} // namespace palpate

#endif
