// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Bodies/DirectPresses.h"

#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/TrueShape/SurfaceGap.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// In contact radii.
constexpr double Reach = 5.0;  ///< of the part
constexpr double Around = 1.4; ///< has facets of this length:
constexpr double Facets = 0.3; ///< a ball's pole is within 1 %
constexpr double Rim = 0.12;   ///< at a flat end's rim: within 2 %
constexpr double Far = 0.8;    ///< away from the tool
constexpr double Longer = 1.5; ///< are the second mesh's
constexpr int RimBalls = 32;
constexpr int MostBoxes = 4;
constexpr double Larger = 1.07;     ///< a box where another cannot be cut
constexpr double Inside = 0.1;      ///< lie loads on the body's coarse cells
constexpr double CoarseReach = 2.5; ///< of the part, in lengths of these cells
} // namespace

DirectPresses::DirectPresses(const PreparedSurface& surface, const RestOfBody& body,
  const RestOfBody& coarser, const DirectTerms& terms)
  : Surface(surface)
  , Body(body)
  , Coarser(coarser)
  , Tool(*terms.tool)
  , Terms(terms)
  , Radius(terms.tool->contactRadius(terms.depth))
{
}

/// `length`: 1 for the finest.
PartCells DirectPresses::cells(const DirectPlace& place, double length) const
{
  const double unit = length * this->Radius;
  PartCells made;
  made.spacing = Far * unit;
  made.balls.push_back({ place.place, Around * this->Radius, Facets * unit });
  if (this->Tool.smallestContactRadius() >= this->Radius)
  {
    const Eigen::Matrix3d frame = SurfaceGap::frame(-place.inward);
    for (int i = 0; i < RimBalls; ++i)
    {
      const double angle = 2.0 * Pi * i / RimBalls;
      const Eigen::Vector3d rim = place.place +
        this->Radius * (std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1));
      made.balls.push_back({ rim, Rim * this->Radius, Rim * unit });
    }
  }
  return made;
}

std::string DirectPresses::make(const DirectPlace& place, const CutOutSurface& cut, double length,
  const RestOfBody& rest, Part& part) const
{
  CutOutPart filled;
  std::string fault = fillPart(cut, this->cells(place, length), filled);
  if (!fault.empty())
  {
    return fault;
  }
  const UnitMotion ofCut = rest.motionAt(
    place.place, Inside * this->Radius * place.inward, filled.mesh.nodes, filled.onCut);
  if (ofCut.nodes.front().size() == 0)
  {
    return "there is not enough memory for the body around it";
  }
  ElasticBodyInput input;
  input.mesh = std::move(filled.mesh);
  input.materials = { this->Terms.material };
  for (std::size_t i = 0; i < filled.onCut.size(); ++i)
  {
    input.fixed.push_back(filled.onCut[i] || filled.held[i] ? FixedX | FixedY | FixedZ : 0);
  }
  ElasticBody& body = part.body;
  fault = body.assemble(std::move(input));
  fault = fault.empty() ? body.analyse(StiffnessFactor::Kind::Automatic) : fault;
  fault = fault.empty() ? body.factorise() : fault;
  if (!fault.empty())
  {
    return fault;
  }
  part.moved = motionFromCut(body, ofCut);
  return part.moved.nodes.front().size() > 0 ? ""
                                             : "there is not enough memory for the part around it";
}

/// At finite strain, or where that is not asked for, or not found on both, at small.
void DirectPresses::press(
  const DirectPlace& place, const Part& finer, const Part& coarser, Contacts& contacts) const
{
  const auto finite = [&](const Part& part)
  { return pressAtFiniteStrain(part.body, this->Tool, place, this->Terms.depth, &part.moved); };
  const auto small = [&](const Part& part)
  {
    return std::make_unique<DirectContact>(
      part.body, this->Tool, place, this->Terms.depth, &part.moved);
  };
  if (this->Terms.solvesFiniteStrain)
  {
    contacts.finer.finite = finite(finer);
    contacts.coarser.finite = finite(coarser);
  }
  if (!isAtFiniteStrain(contacts.finer, this->Terms) ||
    !isAtFiniteStrain(contacts.coarser, this->Terms))
  {
    contacts.finer.small = small(finer);
    contacts.coarser.small = small(coarser);
  }
}

std::string DirectPresses::at(const DirectPlace& place, Contacts& contacts) const
{
  const std::int32_t point = this->Body.pointBeside(place.place, -place.inward);
  if (point < 0)
  {
    return "no point of the solid's surface faces the same way";
  }
  double half =
    std::max(Reach * this->Radius, CoarseReach * this->Body.body().surface().spacing(point));
  std::string fault;
  for (int i = 0; i < MostBoxes; ++i, half *= Larger)
  {
    CutOutSurface cut;
    Part finer;
    Part coarser;
    fault = cutOutAround(this->Surface, place.place, half, cut);
    fault = fault.empty() ? this->make(place, cut, 1.0, this->Body, finer) : fault;
    fault = fault.empty() ? this->make(place, cut, Longer, this->Coarser, coarser) : fault;
    if (fault.empty())
    {
      this->press(place, finer, coarser, contacts);
      break;
    }
  }
  return fault;
}
} // namespace palpate
