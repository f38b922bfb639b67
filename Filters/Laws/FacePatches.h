// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FacePatches_h
#define palpate_FacePatches_h

#include "Laws/LinkedSurface.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace palpate
{
/// A patch that shares sides of facets with another one.
struct NextPatch
{
  int patch;
  bool isSharp; ///< one of these sides turns by PackedMesh::BluntTurn or more
};

/// The facets of a cell that face alike, or one long facet.
struct FacePatch
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< unit
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double area = 0.0; ///< mm²
  bool isLong = false;
  bool isKnown = false;        ///< large enough for its normal to count
  std::vector<NextPatch> next; ///< each once
};

/**
 * A surface in patches of about the size of a cell. Faces at a right angle are never averaged. What
 * a cell cuts off a face joins the next patch that faces most alike: where the cells lie matters
 * little.
 */
class FacePatches
{
public:
  /// Facets of more than `longArea` (mm²) are patches of their own; `cell`: mm. `surface` must
  /// outlive this.
  FacePatches(const LinkedSurface& surface, double cell, double longArea);

  /// How many; some have been joined to others, and hold no facet.
  std::size_t size() const { return this->Patches.size(); }
  const FacePatch& at(int patch) const { return this->Patches[static_cast<std::size_t>(patch)]; }
  /// The patch of a facet; -1 for one without an area.
  int of(std::size_t facet) const { return this->PatchOf[facet]; }

private:
  void makePatches(double longArea);
  void addFacet(std::size_t t, std::size_t patch);
  void joinSmallPatches();
  int mostAlike(int patch, const std::vector<int>& into) const;
  void findNext();
  bool isKnown(const FacePatch& patch) const;

  const LinkedSurface& Surface;
  double Cell;
  std::vector<FacePatch> Patches;
  std::vector<int> PatchOf;
};

Eigen::Vector3d facetCentre(const LinkedSurface& surface, std::size_t facet);
/// By how much facets turn away along side `i` of one, rad; 0 at a border and in a hollow.
double facetTurn(const LinkedSurface& surface, std::size_t facet, std::size_t i);
double angleBetween(const Eigen::Vector3d& one, const Eigen::Vector3d& other);
} // namespace palpate

#endif
