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
/// A neighbour of a patch: both patches have facets with a common side.
struct NextPatch
{
  int patch;
  bool isSharp; ///< whether one of the common sides has a turn of at least PackedMesh::BluntTurn
};

/// Facets of a cell with similar normals, or one long facet.
struct FacePatch
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< unit vector
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double area = 0.0;           ///< mm²
  bool isLong = false;         ///< whether the patch is one long facet
  bool isKnown = false;        ///< whether the patch is large enough for its normal to be used
  std::vector<NextPatch> next; ///< neighbours, without duplicates
};

/**
 * A surface divided into patches of about the size of a cell. Faces at a right angle are never
 * averaged. A small part of a face at the border of a cell is joined to the neighbour with the most
 * similar normal, so that the position of the cells has little influence.
 */
class FacePatches
{
public:
  /// `cell` is the size of a cell, mm. A facet larger than `longArea` (mm²) becomes a separate
  /// patch. `surface` must outlive this object.
  FacePatches(const EdgeSurface& surface, double cell, double longArea);

  /// Number of patches, including empty patches whose facets were joined to other patches.
  std::size_t size() const { return this->Patches.size(); }
  const FacePatch& at(int patch) const { return this->Patches[static_cast<std::size_t>(patch)]; }
  /// Returns the patch of a facet; -1 for a facet without an area.
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
