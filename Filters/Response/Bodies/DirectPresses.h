// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_DirectPresses_h
#define palpate_DirectPresses_h

#include "Laws/DirectCurve.h"
#include "Response/Bodies/CutOutPart.h"
#include "Response/Bodies/RestOfBody.h"

#include <array>
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

  /// A contact, with the part that it belongs to.
  struct Press
  {
    std::unique_ptr<ElasticBody> part;
    std::unique_ptr<DirectContact> contact;
  };
  /// Returns what is wrong with the place, or "". The second on one and a half times longer cells,
  /// in the coarser body.
  std::string at(const DirectPlace& place, std::array<Press, 2>& presses) const;

private:
  PartCells cells(const DirectPlace& place, double length) const;
  std::string press(const DirectPlace& place, const CutOutSurface& part, double length,
    const RestOfBody& rest, Press& press) const;

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
