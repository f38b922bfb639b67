// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_PatchCut_h
#define palpate_PatchCut_h

#include "Solids/FiniteElements/PatchLoad.h"

#include <cstdint>

namespace palpate
{
/// Radii, in spacings, within which elements are cut out: the inner and the outer cut.
constexpr std::array<double, 2> CutReach = { 4.0, 5.5 };

/// The role of a node in a cut.
enum class CutNode : std::uint8_t
{
  Free,
  Prescribed, ///< moves as that of the half-space
  Outside     ///< belongs to no element of this cut
};

/// The elements around a point and their loads: all that a self-term depends on.
struct LocalPatch
{
  VolumeMesh mesh;                           ///< in the tangent frame of the point, flattened
  std::vector<unsigned char> inner;          ///< per element: 1 in the inner cut too
  std::array<std::vector<CutNode>, 2> nodes; ///< per node, for the inner and the outer cut
  std::array<PatchLoad, 2> loads;            ///< on the nodes, in the frame of this mesh
  double poissonRatio = 0.3;
  double spacing = 1.0;               ///< mm
  std::vector<std::int32_t> elements; ///< of the body, from which it was cut
};

/// Cuts out the elements around a surface point: those connected to it whose centre lies within
/// `reach` (mm; inner, outer) of it. Nodes and elements are sorted by position.
LocalPatch cutOut(const VolumeMesh& mesh, const MeshTopology& topology, const BodySurface& surface,
  std::int32_t point, const std::array<PatchLoad, 2>& loads, const std::array<double, 2>& reach,
  double poissonRatio);

/// A hash, equal for equal cut-outs; 128 bits, so that different ones do not collide.
using PatchKey = std::array<std::uint64_t, 2>;
PatchKey patchKey(const LocalPatch& patch);
} // namespace palpate

#endif
