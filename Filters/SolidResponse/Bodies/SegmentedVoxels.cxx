// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/SegmentedVoxels.h"

#include "Mechanics/JoinedText.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <iterator>
#include <map>
#include <set>

namespace palpate
{
namespace
{
constexpr int Margin = 2; // number of empty voxels around the tissues
constexpr std::size_t LeastOfRegion = 8;
constexpr std::size_t ListedLabels = 20;
constexpr std::size_t MostLabels = 1000;

/// Returns a list of the labels of an image, for an error message.
std::string listLabels(const std::set<double>& found)
{
  std::string text;
  if (found.size() > ListedLabels)
  {
    return joined("its values are ", *found.begin(), " to ", *found.rbegin(),
      found.size() > MostLabels ? ", more than " : ", ",
      found.size() > MostLabels ? MostLabels : found.size(),
      " different ones: is it a scan instead of labels?");
  }
  for (const double label : found)
  {
    text += joined(text.empty() ? "" : ", ", label);
  }
  return "its labels are " + text;
}
} // namespace

std::string SegmentedVoxels::take(
  vtkImageData* image, vtkDataArray* values, const std::vector<Tissue>& tissues)
{
  std::map<double, std::int16_t> known;
  for (const Tissue& tissue : tissues)
  {
    known.emplace(tissue.label, static_cast<std::int16_t>(known.size()));
  }
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  std::array<int, 6> box = { extent[1], extent[0], extent[3], extent[2], extent[5], extent[4] };
  std::set<double> found;
  vtkIdType voxel = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++voxel)
      {
        const double value = values->GetComponent(voxel, 0);
        const bool isTissue = known.count(value) > 0;
        if (isTissue)
        {
          box = { std::min(box[0], i), std::max(box[1], i), std::min(box[2], j),
            std::max(box[3], j), std::min(box[4], k), std::max(box[5], k) };
        }
        if (std::isfinite(value) && (isTissue || found.size() <= MostLabels))
        {
          found.insert(value);
        }
      }
    }
  }
  for (const Tissue& tissue : tissues)
  {
    if (found.count(tissue.label) == 0)
    {
      return joined("label ", tissue.label, " is not in the image: ", listLabels(found));
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box[2 * axis] -= Margin;
    box[2 * axis + 1] += Margin;
    this->Size[axis] = static_cast<std::size_t>(box[2 * axis + 1] - box[2 * axis] + 1);
    this->Spacing[axis] = std::abs(image->GetSpacing()[axis]);
  }
  this->Box = vtkSmartPointer<vtkImageData>::New();
  this->Box->SetExtent(box.data());
  this->Box->SetOrigin(image->GetOrigin());
  this->Box->SetSpacing(image->GetSpacing());
  this->Box->SetDirectionMatrix(image->GetDirectionMatrix());
  this->Numbers.assign(this->Size[0] * this->Size[1] * this->Size[2], Empty);
  std::size_t place = 0;
  for (int k = box[4]; k <= box[5]; ++k)
  {
    for (int j = box[2]; j <= box[3]; ++j)
    {
      for (int i = box[0]; i <= box[1]; ++i, ++place)
      {
        if (i >= extent[0] && i <= extent[1] && j >= extent[2] && j <= extent[3] &&
          k >= extent[4] && k <= extent[5])
        {
          std::array<int, 3> at = { i, j, k };
          const auto is = known.find(values->GetComponent(image->ComputePointId(at.data()), 0));
          this->Numbers[place] = is == known.end() ? Empty : is->second;
        }
      }
    }
  }
  return {};
}

/// Calls use(neighbour) for each of the at most six voxels that share a face with `voxel`.
template <class Use>
void SegmentedVoxels::visitNeighbours(std::size_t voxel, const Use& use) const
{
  std::size_t step = 1;
  for (const std::size_t size : this->Size)
  {
    const std::size_t index = voxel / step % size;
    if (index > 0)
    {
      use(voxel - step);
    }
    if (index + 1 < size)
    {
      use(voxel + step);
    }
    step *= size;
  }
}

/// Returns the voxels that are connected to `seed` through voxels for which `belongs` returns true.
/// Marks these voxels in `isTaken`.
template <class Belongs>
std::vector<std::size_t> SegmentedVoxels::takeRegion(
  std::size_t seed, std::vector<char>& isTaken, const Belongs& belongs) const
{
  std::vector<std::size_t> region = { seed };
  isTaken[seed] = 1;
  for (std::size_t next = 0; next < region.size(); ++next)
  {
    this->visitNeighbours(region[next],
      [&](std::size_t other)
      {
        if (isTaken[other] == 0 && belongs(other))
        {
          isTaken[other] = 1;
          region.push_back(other);
        }
      });
  }
  return region;
}

double SegmentedVoxels::keepLargestRegion()
{
  std::vector<char> isTaken(this->Numbers.size(), 0);
  std::vector<std::size_t> largest;
  std::size_t all = 0;
  for (std::size_t seed = 0; seed < this->Numbers.size(); ++seed)
  {
    if (this->Numbers[seed] != Empty && isTaken[seed] == 0)
    {
      std::vector<std::size_t> region = this->takeRegion(
        seed, isTaken, [this](std::size_t voxel) { return this->Numbers[voxel] != Empty; });
      all += region.size();
      if (region.size() > largest.size())
      {
        largest.swap(region);
      }
    }
  }
  if (largest.size() == all)
  {
    return 0.0;
  }
  std::vector<std::int16_t> kept(this->Numbers.size(), Empty);
  for (const std::size_t voxel : largest)
  {
    kept[voxel] = this->Numbers[voxel];
  }
  this->Numbers.swap(kept);
  return 1.0 - static_cast<double>(largest.size()) / static_cast<double>(all);
}

std::size_t SegmentedVoxels::fillCavities(double volume)
{
  const auto isEmpty = [this](std::size_t voxel) { return this->Numbers[voxel] == Empty; };
  std::vector<char> isTaken(this->Numbers.size(), 0);
  // This marks the outside, which is connected through the margin.
  this->takeRegion(0, isTaken, isEmpty);
  std::vector<std::size_t> filled;
  std::size_t regions = 0;
  const double voxel = this->Spacing[0] * this->Spacing[1] * this->Spacing[2];
  for (std::size_t seed = 0; seed < this->Numbers.size(); ++seed)
  {
    if (isEmpty(seed) && isTaken[seed] == 0)
    {
      const std::vector<std::size_t> region = this->takeRegion(seed, isTaken, isEmpty);
      if (static_cast<double>(region.size()) * voxel < volume)
      {
        filled.insert(filled.end(), region.begin(), region.end());
        ++regions;
      }
    }
  }
  if (regions > 0)
  {
    const std::vector<std::int16_t> nearest = this->nearestTissues();
    for (const std::size_t one : filled)
    {
      this->Numbers[one] = nearest[one];
    }
  }
  return regions;
}

/// Returns the tissue of each voxel. An empty voxel gets the tissue with the fewest steps through
/// faces from the voxel.
std::vector<std::int16_t> SegmentedVoxels::nearestTissues() const
{
  std::vector<std::int16_t> nearest = this->Numbers;
  std::vector<std::size_t> front;
  for (std::size_t voxel = 0; voxel < nearest.size(); ++voxel)
  {
    if (nearest[voxel] != Empty && this->touchesEmpty(voxel))
    {
      front.push_back(voxel);
    }
  }
  for (std::size_t next = 0; next < front.size(); ++next)
  {
    const std::size_t voxel = front[next];
    this->visitNeighbours(voxel,
      [&](std::size_t other)
      {
        if (nearest[other] == Empty)
        {
          nearest[other] = nearest[voxel];
          front.push_back(other);
        }
      });
  }
  return nearest;
}

bool SegmentedVoxels::touchesEmpty(std::size_t voxel) const
{
  bool touches = false;
  this->visitNeighbours(voxel,
    [&touches, this](std::size_t other) { touches = touches || this->Numbers[other] == Empty; });
  return touches;
}

double SegmentedVoxels::volume() const
{
  const auto empty = std::count(this->Numbers.begin(), this->Numbers.end(), Empty);
  return static_cast<double>(this->Numbers.size() - static_cast<std::size_t>(empty)) *
    this->Spacing[0] * this->Spacing[1] * this->Spacing[2];
}

double SegmentedVoxels::area() const
{
  const double voxel = this->Spacing[0] * this->Spacing[1] * this->Spacing[2];
  double sum = 0.0;
  std::size_t step = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // The margin is empty. Therefore each outer face of a tissue is between two voxels of the box.
    for (std::size_t i = step; i < this->Numbers.size(); ++i)
    {
      const bool isFace = (this->Numbers[i] == Empty) != (this->Numbers[i - step] == Empty);
      sum += isFace ? voxel / this->Spacing[axis] : 0.0;
    }
    step *= this->Size[axis];
  }
  return 2.0 / 3.0 * sum;
}

double SegmentedVoxels::smallestSide() const
{
  return *std::min_element(this->Spacing.begin(), this->Spacing.end());
}

Eigen::Vector3d SegmentedVoxels::placeOf(std::size_t voxel) const
{
  std::array<int, 6> extent{};
  this->Box->GetExtent(extent.data());
  const int i = extent[0] + static_cast<int>(voxel % this->Size[0]);
  const int j = extent[2] + static_cast<int>(voxel / this->Size[0] % this->Size[1]);
  const int k = extent[4] + static_cast<int>(voxel / this->Size[0] / this->Size[1]);
  Eigen::Vector3d place;
  this->Box->TransformIndexToPhysicalPoint(i, j, k, place.data());
  return place;
}

std::vector<EnclosedRegion> SegmentedVoxels::findEnclosedRegions() const
{
  vtkNew<vtkPoints> points;
  for (std::size_t voxel = 0; voxel < this->Numbers.size(); ++voxel)
  {
    if (this->Numbers[voxel] != Empty && this->touchesEmpty(voxel))
    {
      points->InsertNextPoint(this->placeOf(voxel).data());
    }
  }
  vtkNew<vtkPolyData> skin;
  skin->SetPoints(points);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(skin);
  locator->BuildLocator();
  std::vector<char> isTaken(this->Numbers.size(), 0);
  std::vector<std::pair<std::size_t, EnclosedRegion>> found;
  for (std::size_t seed = 0; seed < this->Numbers.size(); ++seed)
  {
    if (this->Numbers[seed] == Empty || isTaken[seed] != 0)
    {
      continue;
    }
    const std::vector<std::size_t> region = this->takeRegion(seed, isTaken,
      [this, seed](std::size_t voxel) { return this->Numbers[voxel] == this->Numbers[seed]; });
    if (region.size() < LeastOfRegion ||
      std::any_of(region.begin(), region.end(),
        [this](std::size_t voxel) { return this->touchesEmpty(voxel); }))
    {
      continue;
    }
    EnclosedRegion one{ Eigen::Vector3d::Zero(), 0.0, std::numeric_limits<double>::infinity() };
    for (const std::size_t voxel : region)
    {
      one.middle += this->placeOf(voxel) / static_cast<double>(region.size());
    }
    for (const std::size_t voxel : region)
    {
      const Eigen::Vector3d place = this->placeOf(voxel);
      one.radius = std::max(one.radius, (place - one.middle).norm());
      Eigen::Vector3d nearest;
      skin->GetPoint(locator->FindClosestPoint(place.data()), nearest.data());
      one.depth = std::min(one.depth, (place - nearest).norm());
    }
    found.emplace_back(region.size(), one);
  }
  std::stable_sort(
    found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<EnclosedRegion> regions;
  for (const auto& [size, region] : found)
  {
    regions.push_back(region);
  }
  return regions;
}

SkinScan SegmentedVoxels::mask() const
{
  SkinScan scan;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scan.size[axis] = static_cast<int>(this->Size[axis]);
    scan.spacing[axis] = this->Spacing[axis];
  }
  scan.values.reserve(this->Numbers.size());
  std::transform(this->Numbers.begin(), this->Numbers.end(), std::back_inserter(scan.values),
    [](std::int16_t number) { return number == Empty ? 0.0F : 1.0F; });
  return scan;
}

vtkSmartPointer<vtkImageData> SegmentedVoxels::spreadTissues() const
{
  const std::vector<std::int16_t> nearest = this->nearestTissues();
  vtkNew<vtkShortArray> numbers;
  numbers->SetName("Tissue");
  numbers->SetNumberOfValues(static_cast<vtkIdType>(nearest.size()));
  std::copy(nearest.begin(), nearest.end(), numbers->GetPointer(0));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(this->Box);
  image->GetPointData()->SetScalars(numbers);
  return image;
}
} // namespace palpate
