// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolOutline_h
#define palpate_ToolOutline_h

#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"

#include <Eigen/Core>

#include <vector>

namespace palpate
{
/**
 * A tool's outline in the half plane (r, z), z = 0 at its tip and growing into the tool, as
 * circular arcs that go over into each other without a corner: what a distance needs that Newton's
 * method can follow. Where the tool has a corner (the apex of a cone, the rim of a flat) the
 * outline has a fillet, which is part of the answer: it costs a flat end 8 % of its force at a
 * tenth of its radius.
 *
 * Points of the profile are joined by biarcs, exact for circles and straight lines.
 */
class PALPATE_EXPORT ToolOutline
{
public:
  /// Of `tool` out to the radius `reach`, from where it goes on straight (both mm, > 0). A corner
  /// gets a fillet of radius `fillet`, or less where what is beside it is shorter.
  ToolOutline(const AxisymmetricTool& tool, double reach, double fillet);

  /// A signed distance, > 0 outside the tool, with its derivatives by (r, z).
  struct Distance
  {
    double value;
    Eigen::Vector2d gradient; ///< unit, away from the tool
    Eigen::Matrix2d hessian;
  };
  Distance distance(const Eigen::Vector2d& point) const;

  /// z of the outline at r; +inf beyond its wall.
  double height(double r) const;

  /// Radii where fillets lie (from, to), for a mesh to be fine there, mm; none where no corner is.
  const std::vector<std::pair<double, double>>& fillets() const { return this->Fillets; }

private:
  /// Goes from a point in a direction, its left side into the tool, and turns left by `curvature`.
  struct Arc
  {
    Eigen::Vector2d from;
    Eigen::Vector2d direction; ///< unit
    double curvature;          ///< 1/mm; 0: straight
    double length;
  };
  struct Node
  {
    Eigen::Vector2d point;
    Eigen::Vector2d direction;
  };

  /// A smooth part of the profile.
  class Part;
  /// Each goes on from the end of what there is, `last`, and says where its own end is.
  Node addCorner(const Part& part, double fillet, const Node& last, bool isApex);
  Node addPart(const Part& part, const Node& last);
  Node addWall(const Part& part, double fillet, const Node& last);
  void addFillet(const Node& before, const Node& after);
  void join(const Node& from, const Node& to);
  void addArc(const Node& from, const Eigen::Vector2d& to);

  std::vector<Arc> Arcs;
  std::vector<std::pair<double, double>> Fillets;
};
} // namespace palpate

#endif
