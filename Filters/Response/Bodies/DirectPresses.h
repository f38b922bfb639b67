// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectPresses_h
#define palpate_DirectPresses_h

#include "Laws/DirectCurve.h"
#include "Response/Bodies/CutOutPart.h"
#include "Response/Bodies/RestOfBody.h"

#include <memory>
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
  /// The surface, the bodies and the tool must stay; `coarser` is `body` in longer cells. `depth`
  /// (mm), the deepest.
  DirectPresses(const PreparedSurface& surface, const RestOfBody& body, const RestOfBody& coarser,
    const AxisymmetricTool& tool, const ElasticMaterial& material, double depth);

  struct Contacts
  {
    std::unique_ptr<DirectContact> finer;
    std::unique_ptr<DirectContact> coarser; ///< on cells one and a half times as long
  };
  /// Returns what is wrong with the place, or "".
  std::string at(const DirectPlace& place, Contacts& contacts) const;

private:
  PartCells cells(const DirectPlace& place, double length) const;
  std::string press(const DirectPlace& place, const CutOutSurface& part, double length,
    const RestOfBody& rest, std::unique_ptr<DirectContact>& contact) const;

  const PreparedSurface& Surface;
  const RestOfBody& Body;
  const RestOfBody& Coarser;
  const AxisymmetricTool& Tool;
  ElasticMaterial Material;
  double Depth;
  double Radius; ///< of the contact on a half-space, mm
};
} // namespace palpate

#endif
