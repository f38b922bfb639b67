// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TrackedMethod.h"

#include <cstdint>
#include <vector>

namespace palpate::testing
{
/**
 * Forces from the vertices of the mesh that lie inside the tool: each is pushed out by a spring as
 * strong as the area it stands for, and all are summed along the normal of the contact, which is
 * also the tool's axis. (With springs that know no area, half the edge would be four times the
 * force.) The springs per area are calibrated so that on an endless fine mesh the tool `known`,
 * pressed half its range, feels what it should at the body's first point.
 */
class PenetratingVertices final : public TrackedMethod
{
public:
  PenetratingVertices(const std::string& name, const StudyBody& body, const StudyLaw& known,
    std::shared_ptr<const AxisymmetricTool> tool);

protected:
  double magnitude(const TouchedPlace& place) override;
  std::size_t modelBytes() const override;

private:
  struct Vertex
  {
    Eigen::Vector3f position; ///< local
    float stiffness;          ///< N/mm
  };
  void visit(std::int32_t vertex);
  /// How far the tool's surface reaches below the undeformed one, r from its axis; mm.
  double penetration(double r, double depth) const { return depth - this->Tool->profile(r); }

  std::shared_ptr<const AxisymmetricTool> Tool;
  std::vector<Vertex> Vertices;
  std::vector<std::uint32_t> SeenAt; ///< the tick in which a vertex was met last
  std::uint32_t Tick = 0;
  std::vector<std::int32_t> Queue;
};
} // namespace palpate::testing
