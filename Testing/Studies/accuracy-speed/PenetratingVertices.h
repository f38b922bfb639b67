// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "TrackedMethod.h"

#include <cstdint>
#include <vector>

namespace palpate::testing
{
/**
 * Forces from the mesh vertices inside the tool. A spring pushes each vertex out; its stiffness is
 * proportional to the area of the vertex. The sum of the forces acts along the normal of the
 * contact, which is also the tool's axis. (Without the areas, half the edge length would give four
 * times the force.) The springs per area are calibrated on an infinitely fine mesh: there the tool
 * `known`, pressed to half its range, gets the correct force at the first point of the body.
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
    Eigen::Vector3f position; ///< in local coordinates
    float stiffness;          ///< N/mm
  };
  void visit(std::int32_t vertex);
  /// Depth of the tool's surface below the undeformed one at the distance r from its axis, mm.
  double penetration(double r, double depth) const { return depth - this->Tool->profile(r); }

  std::shared_ptr<const AxisymmetricTool> Tool;
  std::vector<Vertex> Vertices;
  std::vector<std::uint32_t> SeenAt; ///< the last tick in which a vertex was visited
  std::uint32_t Tick = 0;
  std::vector<std::int32_t> Queue;
};
} // namespace palpate::testing
