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
 * Presses a tool at places of a body, each on a part of its own that is cut out around it and fine
 * under the tool; what is around that moves as in the body's coarse cells. From any number of
 * threads.
 *
 * The part reaches five contact radii from the place: on a half-space what lies beyond is an eighth
 * of the compliance, of which coarse cells miss some hundredths. Where that does not do, as two
 * meshes differ or the tool reaches farther, it reaches eight.
 */
class DirectPresses
{
public:
  /// The surface, the bodies and the tool must stay; `coarser` is `body` in longer cells. `terms`
  /// tell the tool, the material, how deep, and whether at finite strain.
  DirectPresses(const PreparedSurface& surface, const RestOfBody& body, const RestOfBody& coarser,
    const DirectTerms& terms);

  struct Contacts
  {
    DirectPress finer;
    DirectPress coarser; ///< on cells one and a half times as long
  };
  /// Returns what is wrong with the place, or "".
  std::string at(const DirectPlace& place, Contacts& contacts) const;

private:
  /// What is pressed on.
  struct Part
  {
    ElasticBody body;
    UnitMotion moved;                 ///< by what is around
    std::vector<unsigned char> onCut; ///< nodes
    std::vector<unsigned char> held;
  };
  /// How long cells are; 1 for the finest.
  struct Lengths
  {
    double near = 1.0;
    double far = 1.0;
  };
  PartCells cells(const DirectPlace& place, const Lengths& lengths) const;
  std::string make(const DirectPlace& place, const CutOutSurface& cut, const Lengths& lengths,
    const RestOfBody& rest, Part& part) const;
  /// In a box that reaches so many times as far as it should, in as many cells, or the next larger
  /// that can be cut. `isBeyond`: the tool comes upon where that was cut off.
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
