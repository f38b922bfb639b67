// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/FiniteElements/RegularField.h"

#include "Solids/FiniteElements/PatchSelfTerm.h"
#include "Solids/FiniteElements/PatchSite.h"
#include "Solids/FiniteElements/VisibleDent.h"

namespace palpate
{
namespace
{
/// Weights of the two patches. Their combination equals a point force up to terms of order c⁴.
constexpr std::array<double, 2> PatchWeights = { 4.0 / 3.0, -1.0 / 3.0 };

/// Computes the dent at points of the surface from the elements around the loaded point. Returns
/// the points and the displacement along x, y, z of each.
std::vector<std::pair<std::int32_t, Eigen::Vector3d>> dentOfElements(
  const ElasticBody& body, std::int32_t point, const LocalPatch& patch)
{
  const BodySurface& surface = body.surface();
  const std::array<Eigen::Matrix3Xd, 2> motions = patchMotions(patch);
  const Eigen::Matrix3Xd moved = tangentFrame(surface.normal(point)) *
    (PatchWeights[0] * motions[0] + PatchWeights[1] * motions[1]);
  std::vector<std::pair<std::int32_t, Eigen::Vector3d>> found;
  std::vector<unsigned char> seen(patch.nodes[1].size(), 0);
  for (std::size_t e = 0; e < patch.elements.size(); ++e)
  {
    const VolumeElement& whole = body.mesh().elements[static_cast<std::size_t>(patch.elements[e])];
    const VolumeElement& cut = patch.mesh.elements[e];
    for (std::size_t i = 0; i < static_cast<std::size_t>(nodeCount(cut.kind)); ++i)
    {
      const std::int32_t at = surface.pointOfNode(whole.nodes[i]);
      if (at >= 0 && !seen[static_cast<std::size_t>(cut.nodes[i])])
      {
        seen[static_cast<std::size_t>(cut.nodes[i])] = 1;
        found.emplace_back(at, moved.col(cut.nodes[i]));
      }
    }
  }
  return found;
}
} // namespace

Eigen::Matrix3Xd RegularField::at(std::int32_t point) const
{
  const BodySurface& surface = this->Body.surface();
  const auto loads = patchLoadsAt(this->Body, point, this->Radius);
  const LocalPatch patch = patchCutAt(this->Body, point, this->Radius, loads);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, this->Body.mesh().nodes.cols());
  for (std::size_t k = 0; k < 2; ++k)
  {
    for (const auto& [node, weight] : loads[k].nodes)
    {
      forces.col(node) -= PatchWeights[k] * weight * surface.normal(point);
    }
  }
  const Eigen::Matrix3Xd whole = this->Body.displacement(forces);

  const std::vector<double> fades = dentFades(surface, point);
  const double modulus = this->Body.materialAt(surface.node(point)).youngsModulus;
  Eigen::Matrix3Xd dent = Eigen::Matrix3Xd::Zero(3, surface.pointTotal());
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    if (i != point && fades[static_cast<std::size_t>(i)] > 0.0)
    {
      dent.col(i) = dentAt(surface, point, i, patch.spacing, patch.poissonRatio);
    }
  }
  for (const auto& [i, moved] : dentOfElements(this->Body, point, patch))
  {
    dent.col(i) = moved;
  }
  Eigen::Matrix3Xd field(3, surface.pointTotal());
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    const double fade = fades[static_cast<std::size_t>(i)];
    field.col(i) = whole.col(surface.node(i));
    if (fade > 0.0)
    {
      field.col(i) -= fade / modulus * dent.col(i);
    }
  }
  return field;
}
} // namespace palpate
