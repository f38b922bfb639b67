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
 * circular arcs joined without corners, so that the distance is smooth enough for Newton's method.
 * Where the tool has a corner (the apex of a cone, the rim of a flat) the outline has a fillet,
 * which changes the result: one of a tenth of its radius costs a flat end 8 % of its force.
 *
 * Points of the profile are joined by biarcs, exact for circles and straight lines.
 */
class PALPATE_EXPORT ToolOutline
{
public:
  /// The outline of `tool` out to the radius `reach`, and straight from there (both mm, > 0). A
  /// corner gets a fillet of radius `fillet`, or less where the sides beside it are shorter.
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

  /// Ranges of radii (from, to) of the fillets, where a mesh must be fine, mm; none without
  /// corners.
  const std::vector<std::pair<double, double>>& fillets() const { return this->Fillets; }

private:
  /// An arc from a point in a direction, the tool on its left, turning left by `curvature`.
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
  /// Each continues from the end of the outline so far, `last`, and returns its own end.
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
