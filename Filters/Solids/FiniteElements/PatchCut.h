// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PatchCut_h
#define palpate_PatchCut_h

#include "Solids/FiniteElements/PatchLoad.h"

#include <cstdint>

namespace palpate
{
/// Radii of the inner and the outer cut, in spacings.
constexpr std::array<double, 2> CutReach = { 4.0, 5.5 };

/// The role of a node in a cut.
enum class CutNode : std::uint8_t
{
  Free,
  Prescribed, ///< the displacement of the node is that of the half-space
  Outside     ///< the node does not belong to any element of this cut
};

/// The elements around a point and the loads on them. They are the complete input of a self-term.
struct LocalPatch
{
  VolumeMesh mesh; ///< the cut-out elements, flattened, in the tangent frame of the point
  /// Per element: 1 if the element is also in the inner cut.
  std::vector<unsigned char> inner;
  std::array<std::vector<CutNode>, 2> nodes; ///< role of each node, for the inner and the outer cut
  std::array<PatchLoad, 2> loads;            ///< loads on the nodes, with node numbers of this mesh
  double poissonRatio = 0.3;
  double spacing = 1.0;               ///< distance of neighbouring nodes at the point, mm
  std::vector<std::int32_t> elements; ///< indices in the body of the elements that were cut out
};

/// Cuts out the elements around a surface point. These are the elements that are connected to the
/// point and have their centre within `reach` (mm), which contains the inner and the outer radius.
/// Nodes and elements are sorted by position.
LocalPatch cutOut(const VolumeMesh& mesh, const MeshTopology& topology, const BodySurface& surface,
  std::int32_t point, const std::array<PatchLoad, 2>& loads, const std::array<double, 2>& reach,
  double poissonRatio);

/// A hash that is equal for equal cut-outs. It has 128 bits. Therefore a collision of different
/// cut-outs is practically impossible.
using PatchKey = std::array<std::uint64_t, 2>;
PatchKey patchKey(const LocalPatch& patch);
} // namespace palpate

#endif
