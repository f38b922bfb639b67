// SPDX-License-Identifier: BSD-3-Clause
#include "Laws/FacePatches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace palpate
{
namespace
{
using Eigen::Vector3d;

// Smallest cosine between the normals of two facets in one patch.
constexpr double LeastPatchCosine = 0.15;
// Smallest area of a patch as a fraction of a cell's area. The normal of a smaller patch is not
// used.
constexpr double LeastArea = 0.2;

double cosineBetween(const Vector3d& one, const Vector3d& other)
{
  return one.dot(other) / (one.norm() * other.norm());
}

using CellPlace = std::array<std::int64_t, 3>;

struct CellHash
{
  std::size_t operator()(const CellPlace& place) const
  {
    std::uint64_t mixed = 0;
    for (const std::int64_t part : place)
    {
      mixed = (mixed ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
      mixed ^= mixed >> 32;
    }
    return static_cast<std::size_t>(mixed);
  }
};

int rootOf(const std::vector<int>& into, int patch)
{
  while (into[static_cast<std::size_t>(patch)] != patch)
  {
    patch = into[static_cast<std::size_t>(patch)];
  }
  return patch;
}
} // namespace

FacePatches::FacePatches(const EdgeSurface& surface, double cell, double longArea)
  : Surface(surface)
  , Cell(cell)
  , PatchOf(surface.corners.size(), -1)
{
  this->makePatches(longArea);
  this->findNext();
  this->joinSmallPatches();
  for (FacePatch& patch : this->Patches)
  {
    patch.centre /= patch.area;
    patch.normal.normalize();
    patch.isKnown = this->isKnown(patch);
  }
  this->findNext();
}

/// Sorts facets lexicographically by their cells. Facets of one cell keep their order. `begin`
/// receives the first position of each cell, and finally the number of facets.
std::vector<std::int32_t> FacePatches::sortByCell(
  const std::vector<std::int32_t>& facets, std::vector<std::size_t>& begin) const
{
  std::unordered_map<CellPlace, std::int32_t, CellHash> known;
  std::vector<CellPlace> places;
  std::vector<std::int32_t> cellOf;
  cellOf.reserve(facets.size());
  for (const std::int32_t facet : facets)
  {
    const Vector3d centre =
      facetCentre(this->Surface, static_cast<std::size_t>(facet)) / this->Cell;
    CellPlace place{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      place[k] = static_cast<std::int64_t>(std::floor(centre[static_cast<Eigen::Index>(k)]));
    }
    if (!cellOf.empty() && places[static_cast<std::size_t>(cellOf.back())] == place)
    {
      cellOf.push_back(cellOf.back());
      continue;
    }
    const auto [cell, isNew] = known.try_emplace(place, static_cast<std::int32_t>(places.size()));
    if (isNew)
    {
      places.push_back(place);
    }
    cellOf.push_back(cell->second);
  }
  std::vector<std::int32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&places](std::int32_t one, std::int32_t other)
    { return places[static_cast<std::size_t>(one)] < places[static_cast<std::size_t>(other)]; });
  std::vector<std::size_t> next(places.size(), 0);
  for (const std::int32_t cell : cellOf)
  {
    ++next[static_cast<std::size_t>(cell)];
  }
  begin = { 0 };
  for (const std::int32_t cell : order)
  {
    std::size_t& count = next[static_cast<std::size_t>(cell)];
    begin.push_back(begin.back() + count);
    count = begin[begin.size() - 2];
  }
  std::vector<std::int32_t> sorted(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    sorted[next[static_cast<std::size_t>(cellOf[i])]++] = facets[i];
  }
  return sorted;
}

/// Combines the facets of each cell whose normals are similar into one patch. A facet belongs to
/// the cell that contains its centre.
void FacePatches::makePatches(double longArea)
{
  std::vector<std::int32_t> facets;
  facets.reserve(this->PatchOf.size());
  for (std::size_t t = 0; t < this->PatchOf.size(); ++t)
  {
    if (this->Surface.corners[t][0] < 0)
    {
      continue;
    }
    if (this->Surface.areas[t].norm() > longArea)
    {
      this->addFacet(t, this->Patches.size());
      this->Patches.back().isLong = true;
      continue;
    }
    facets.push_back(static_cast<std::int32_t>(t));
  }
  std::vector<std::size_t> begin;
  const std::vector<std::int32_t> sorted = this->sortByCell(facets, begin);
  for (std::size_t cell = 0; cell + 1 < begin.size(); ++cell)
  {
    const std::size_t first = this->Patches.size(); // index of the first patch of this cell
    for (std::size_t i = begin[cell]; i < begin[cell + 1]; ++i)
    {
      const auto t = static_cast<std::size_t>(sorted[i]);
      std::size_t found = first;
      while (found < this->Patches.size() &&
        !(cosineBetween(this->Patches[found].normal, this->Surface.areas[t]) > LeastPatchCosine))
      {
        ++found;
      }
      this->addFacet(t, found);
    }
  }
}

/// Adds a facet to an existing or new patch. Until all facets are added, normals and centres are
/// sums weighted by area.
void FacePatches::addFacet(std::size_t t, std::size_t patch)
{
  if (patch == this->Patches.size())
  {
    this->Patches.emplace_back();
  }
  FacePatch& here = this->Patches[patch];
  const double area = this->Surface.areas[t].norm();
  here.normal += this->Surface.areas[t];
  here.centre += area * facetCentre(this->Surface, t);
  here.area += area;
  this->PatchOf[t] = static_cast<int>(patch);
}

void FacePatches::joinSmallPatches()
{
  std::vector<int> small;
  for (std::size_t c = 0; c < this->Patches.size(); ++c)
  {
    if (!this->isKnown(this->Patches[c]))
    {
      small.push_back(static_cast<int>(c));
    }
  }
  std::sort(small.begin(), small.end(),
    [this](int one, int other)
    { return std::pair(this->at(one).area, one) < std::pair(this->at(other).area, other); });
  std::vector<int> into(this->Patches.size());
  std::iota(into.begin(), into.end(), 0);
  for (const int patch : small)
  {
    const FacePatch& here = this->at(patch);
    const int best = this->isKnown(here) ? -1 : this->mostAlike(patch, into);
    if (best < 0)
    {
      continue;
    }
    FacePatch& whole = this->Patches[static_cast<std::size_t>(best)];
    whole.normal += here.normal;
    whole.centre += here.centre;
    whole.area += here.area;
    whole.next.insert(whole.next.end(), here.next.begin(), here.next.end());
    into[static_cast<std::size_t>(patch)] = best;
  }
  for (int& patch : this->PatchOf)
  {
    patch = patch < 0 ? patch : rootOf(into, patch);
  }
}

/// Returns the neighbour of a small patch with the most similar normal. Long facets, and patches
/// whose normals differ too much, are excluded. Returns -1 if no neighbour remains.
int FacePatches::mostAlike(int patch, const std::vector<int>& into) const
{
  int best = -1;
  double alike = LeastPatchCosine;
  for (const NextPatch& beside : this->at(patch).next)
  {
    const int next = rootOf(into, beside.patch);
    const double cosine = cosineBetween(this->at(patch).normal, this->at(next).normal);
    if (next != patch && !this->at(next).isLong && cosine > alike)
    {
      best = next;
      alike = cosine;
    }
  }
  return best;
}

void FacePatches::findNext()
{
  for (FacePatch& patch : this->Patches)
  {
    patch.next.clear();
  }
  for (std::size_t t = 0; t < this->PatchOf.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::int32_t other = this->Surface.links.neighbours(t)[i];
      const int here = this->PatchOf[t];
      if (here < 0 || other < 0 || here == this->PatchOf[static_cast<std::size_t>(other)])
      {
        continue;
      }
      this->Patches[static_cast<std::size_t>(here)].next.push_back(
        { this->PatchOf[static_cast<std::size_t>(other)], this->Surface.isSteep(t, i) });
    }
  }
  for (FacePatch& patch : this->Patches)
  {
    std::vector<NextPatch>& next = patch.next;
    std::sort(next.begin(), next.end(),
      [](const NextPatch& one, const NextPatch& other)
      { return std::pair(one.patch, !one.isSharp) < std::pair(other.patch, !other.isSharp); });
    const auto last = std::unique(next.begin(), next.end(),
      [](const NextPatch& one, const NextPatch& other) { return one.patch == other.patch; });
    next.erase(last, next.end());
  }
}

bool FacePatches::isKnown(const FacePatch& patch) const
{
  return patch.isLong || patch.area > LeastArea * this->Cell * this->Cell;
}
} // namespace palpate
