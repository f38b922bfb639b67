// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectPresses_h
#define palpate_DirectPresses_h

#include "Laws/DirectCurve.h"
#include "Response/Bodies/CutOutPart.h"
#include "Response/Bodies/RestOfBody.h"

#include <string>

namespace palpate
{
/**
 * Presses a tool at places of a body, each on a part of its own that is cut out around it and fine
 * under the tool; what is around that moves as in the body's coarse cells. From any number of
 * threads.
 *
 * The part reaches five contact radii from the place: on a half-space what lies beyond is an eighth
 * of the compliance, of which coarse cells miss some hundredths.
 */
class DirectPresses
{
public:
  /// The surface, the bodies and the tool must stay; `coarser` is `body` in longer cells. `terms`
  /// tell the tool, the material and how deep; at finite strain it is pressed where they ask for
  /// Neo-Hooke and the tool allows it.
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
    UnitMotion moved; ///< by what is around
  };
  PartCells cells(const DirectPlace& place, double length) const;
  std::string make(const DirectPlace& place, const CutOutSurface& cut, double length,
    const RestOfBody& rest, Part& part) const;
  void press(
    const DirectPlace& place, const Part& finer, const Part& coarser, Contacts& contacts) const;

  const PreparedSurface& Surface;
  const RestOfBody& Body;
  const RestOfBody& Coarser;
  const AxisymmetricTool& Tool;
  DirectTerms Terms;
  double Radius; ///< of the contact on a half-space, mm
};
} // namespace palpate

#endif
