// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/DirectPresses.h"

#include "Mechanics/Checked.h"
#include "Mechanics/Numerics/Constants.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Solids/TrueShape/SurfaceGap.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// The following lengths are in contact radii.
constexpr double BoxHalfSide = 5.0;    ///< half the side length of the part's box
constexpr double FineBallRadius = 1.4; ///< radius of the fine ball under the tool
/// Length of the facets in the fine ball. It gives an error of the force of 1 % at the pole of a
/// sphere.
constexpr double FacetLength = 0.3;
/// Radius and facet length of the balls at the rim of a flat end. They give an error of the force
/// of 2 %.
constexpr double RimBallRadius = 0.12;
constexpr double FarFacetLength = 0.8;   ///< length of the facets away from the tool
constexpr double SecondMeshFactor = 1.5; ///< factor on the cell lengths for the second mesh
constexpr int RimBalls = 32;
constexpr int MostBoxes = 4;
/// Factor on the size of the box if the surface cannot be cut at the previous box.
constexpr double NextBoxFactor = 1.07;
/// Factor on the size of the box and its cells if the first result is not accurate enough. A larger
/// part depends less on the coarse cells around it.
constexpr double WiderBoxFactor = 1.6;
/// Depth below the surface at which the loads act on the coarse cells.
constexpr double LoadDepth = 0.1;
/// Smallest half side length of the box, in spacings of the coarse cells.
constexpr double CoarseBoxHalfSide = 2.5;
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

PartCells DirectPresses::cells(const DirectPlace& place, const Lengths& lengths) const
{
  const double unit = lengths.near * this->Radius;
  PartCells made;
  made.spacing = FarFacetLength * lengths.far * this->Radius;
  made.balls.push_back({ place.place, FineBallRadius * this->Radius, FacetLength * unit });
  if (this->Tool.smallestContactRadius() >= this->Radius)
  {
    const Eigen::Matrix3d frame = SurfaceGap::frame(-place.inward);
    for (int i = 0; i < RimBalls; ++i)
    {
      const double angle = 2.0 * Pi * i / RimBalls;
      const Eigen::Vector3d rim = place.place +
        this->Radius * (std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1));
      made.balls.push_back({ rim, RimBallRadius * this->Radius, RimBallRadius * unit });
    }
  }
  return made;
}

std::string DirectPresses::make(const DirectPlace& place, const CutOutSurface& cut,
  const Lengths& lengths, const RestOfBody& rest, Part& part) const
{
  CutOutPart filled;
  std::string fault = fillPart(cut, this->cells(place, lengths), filled);
  if (!fault.empty())
  {
    return fault;
  }
  const UnitMotion ofCut = rest.motionAt(
    place.place, LoadDepth * this->Radius * place.inward, filled.mesh.nodes, filled.onCut);
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
  part.onCut = std::move(filled.onCut);
  part.held = std::move(filled.held);
  ElasticBody& body = part.body;
  fault = firstFault([&] { return body.assemble(std::move(input)); },
    [&] { return body.analyse(StiffnessFactor::Kind::Automatic); },
    [&] { return body.factorise(); });
  if (!fault.empty())
  {
    return fault;
  }
  part.moved = motionFromCut(body, ofCut);
  return part.moved.nodes.front().size() > 0 ? ""
                                             : "there is not enough memory for the part around it";
}

DirectPress DirectPresses::press(const DirectPlace& place, const Part& part) const
{
  const double depth = this->Terms.depth;
  DirectPress made;
  if (this->Terms.solvesFiniteStrain)
  {
    made.finite = pressAtFiniteStrain(part.body, this->Tool, place, depth, &part.moved);
  }
  else
  {
    made.small = std::make_unique<DirectContact>(part.body, this->Tool, place, depth, &part.moved);
  }
  return made;
}

std::string DirectPresses::pressIn(
  double wider, const DirectPlace& place, Contacts& contacts, bool& isBeyond) const
{
  const std::int32_t point = this->Body.nearestPoint(place.place, -place.inward);
  if (point < 0)
  {
    return "no point of the solid's surface faces the same way";
  }
  double half = wider *
    std::max(
      BoxHalfSide * this->Radius, CoarseBoxHalfSide * this->Body.body().surface().spacing(point));
  std::string fault = "it has no part";
  for (int i = 0; i < MostBoxes && !fault.empty(); ++i, half *= NextBoxFactor)
  {
    CutOutSurface cut;
    Part finer;
    Part coarser;
    fault = firstFault([&] { return cutOutAround(this->Surface, place.place, half, cut); },
      [&] {
        return this->make(place, cut, { 1.0, wider }, this->Body, finer);
      },
      [&]
      {
        return this->make(
          place, cut, { SecondMeshFactor, SecondMeshFactor * wider }, this->Coarser, coarser);
      });
    if (!fault.empty())
    {
      continue;
    }
    const std::vector<ToolFacet> under =
      facetsUnder(finer.body, this->Tool, place, this->Terms.depth);
    if (depthOfMarked(under, finer.held, this->Tool) < this->Terms.depth)
    {
      return "the tool reaches held points";
    }
    isBeyond = depthOfMarked(under, finer.onCut, this->Tool) < this->Terms.depth;
    if (isBeyond)
    {
      return "the tool touches the body outside the part";
    }
    contacts = { this->press(place, finer), this->press(place, coarser) };
  }
  return fault;
}

std::string DirectPresses::at(const DirectPlace& place, Contacts& contacts) const
{
  bool isBeyond = false;
  const std::string fault = this->pressIn(1.0, place, contacts, isBeyond);
  const bool isMade = fault.empty();
  const bool isOpen =
    isMade ? !meshesAgree(contacts.finer, contacts.coarser, this->Terms) : isBeyond;
  Contacts again;
  if (isOpen && this->pressIn(WiderBoxFactor, place, again, isBeyond).empty())
  {
    contacts = std::move(again);
    return "";
  }
  return fault;
}
} // namespace palpate
