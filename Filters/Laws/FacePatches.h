// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FacePatches_h
#define palpate_FacePatches_h

#include "Laws/EdgeSurface.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A neighbour of a patch: the two patches share sides of facets.
struct NextPatch
{
  int patch;
  bool isSharp; ///< one of the shared sides has a turn of at least PackedMesh::BluntTurn
};

/// The facets of a cell with similar normals, or one long facet.
struct FacePatch
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< unit
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double area = 0.0; ///< mm²
  bool isLong = false;
  bool isKnown = false;        ///< large enough for its normal to be used
  std::vector<NextPatch> next; ///< neighbours, without duplicates
};

/**
 * A surface, divided into patches of about the size of a cell. Faces at a right angle are never
 * averaged. A small part of a face at the border of a cell joins the neighbour with the most
 * similar normal, so that the position of the cells has little influence.
 */
class FacePatches
{
public:
  /// A facet larger than `longArea` (mm²) is a separate patch. `cell`: size of a cell, mm.
  /// `surface` must outlive this.
  FacePatches(const EdgeSurface& surface, double cell, double longArea);

  /// Number of patches, including the patches without facets that were joined to others.
  std::size_t size() const { return this->Patches.size(); }
  const FacePatch& at(int patch) const { return this->Patches[static_cast<std::size_t>(patch)]; }
  /// The patch of a facet; -1 for a facet without an area.
  int of(std::size_t facet) const { return this->PatchOf[facet]; }

private:
  void makePatches(double longArea);
  std::vector<std::int32_t> sortByCell(
    const std::vector<std::int32_t>& facets, std::vector<std::size_t>& begin) const;
  void addFacet(std::size_t t, std::size_t patch);
  void joinSmallPatches();
  int mostAlike(int patch, const std::vector<int>& into) const;
  void findNext();
  bool isKnown(const FacePatch& patch) const;

  const EdgeSurface& Surface;
  double Cell;
  std::vector<FacePatch> Patches;
  std::vector<int> PatchOf;
};
} // namespace palpate

#endif
