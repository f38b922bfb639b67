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
 * A tool's outline in the half plane (r, z); z is 0 at the tip and increases into the tool. The
 * outline consists of circular arcs that are joined without corners, so that the distance is smooth
 * enough for Newton's method. At a corner of the tool (the apex of a cone, the rim of a flat end)
 * the outline has a fillet. The fillet changes the result: a fillet of a tenth of its radius
 * reduces the force of a flat end by 8 %.
 *
 * Points of the profile are joined by biarcs, which are exact for circles and straight lines.
 */
class PALPATE_EXPORT ToolOutline
{
public:
  /// Creates the outline of `tool` up to the radius `reach`, and a straight continuation beyond it
  /// (mm, > 0). A corner is replaced by a fillet of radius `fillet` (mm, > 0), or by a smaller one
  /// if the sides of the corner are too short.
  ToolOutline(const AxisymmetricTool& tool, double reach, double fillet);

  /// A signed distance, positive outside the tool, and its derivatives with respect to (r, z).
  struct Distance
  {
    double value;
    Eigen::Vector2d gradient; ///< unit vector, away from the tool
    Eigen::Matrix2d hessian;
  };
  Distance distance(const Eigen::Vector2d& point) const;

  /// Returns z of the outline at r, mm; +inf beyond the tool's wall.
  double height(double r) const;

  /// Ranges of radii (from, to) of the fillets, mm, in which a mesh must be fine. Empty if there
  /// are no corners.
  const std::vector<std::pair<double, double>>& fillets() const { return this->Fillets; }

private:
  /// An arc from a start point in a direction. The tool is on its left; an arc with `curvature` > 0
  /// turns left.
  struct Arc
  {
    Eigen::Vector2d from;
    Eigen::Vector2d direction; ///< unit vector
    double curvature;          ///< 1/mm; 0 if the arc is straight
    double length;
  };
  struct Node
  {
    Eigen::Vector2d point;
    Eigen::Vector2d direction;
  };

  /// A smooth part of the profile.
  class Part;
  /// Each of these functions extends the outline from its present end `last`, and returns the new
  /// end.
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
