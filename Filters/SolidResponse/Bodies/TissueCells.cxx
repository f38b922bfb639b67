// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/TissueCells.h"

#include "Mechanics/JoinedText.h"
#include "SolidResponse/Bodies/CellPlaces.h"
#include "SolidResponse/Bodies/VolumeConversion.h"
#include "Solids/TrueShape/InclusionMixing.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr vtkIdType ScannedCellsPerAbortCheck = 4096; // number of cells between checks for an abort

/// Reads values of an image at points.
class ScanReader
{
public:
  ScanReader(vtkImageData* image, vtkDataArray* values)
    : Image(image)
    , Values(values)
  {
  }

  /// Reads the value of the nearest voxel, or interpolates trilinearly between the eight nearest
  /// voxels. Returns false if the position is outside the image.
  bool read(const std::array<double, 3>& place, bool nearest, double& value) const
  {
    std::array<double, 3> index{};
    this->Image->TransformPhysicalPointToContinuousIndex(place.data(), index.data());
    std::array<int, 6> extent{};
    this->Image->GetExtent(extent.data());
    std::array<std::array<int, 2>, 3> beside{};
    std::array<double, 3> part{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double low = extent[2 * k];
      const double high = extent[2 * k + 1];
      // The outermost voxels extend by half a voxel beyond their centres.
      if (!(index[k] >= low - 0.5 && index[k] <= high + 0.5))
      {
        return false;
      }
      const double at = std::clamp(nearest ? std::round(index[k]) : index[k], low, high);
      const double below = std::min(std::floor(at), std::max(low, high - 1.0));
      part[k] = at - below;
      beside[k] = { static_cast<int>(below), static_cast<int>(std::min(below + 1.0, high)) };
    }
    value = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      std::array<int, 3> voxel{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t side = corner >> k & 1U;
        weight *= side == 1 ? part[k] : 1.0 - part[k];
        voxel[k] = beside[k][side];
      }
      if (weight > 0.0)
      {
        value += weight * this->Values->GetComponent(this->Image->ComputePointId(voxel.data()), 0);
      }
    }
    return true;
  }

private:
  vtkImageData* Image;
  vtkDataArray* Values;
};

/// Interpolates log E and ν linearly between the rows of a map.
ElasticMaterial onScale(const TissueMap& map, double value)
{
  const auto above = map.lower_bound(value);
  if (above == map.end())
  {
    return std::prev(above)->second;
  }
  if (above == map.begin())
  {
    return above->second;
  }
  const auto below = std::prev(above);
  const double part = (value - below->first) / (above->first - below->first);
  const ElasticMaterial& a = below->second;
  const ElasticMaterial& b = above->second;
  return { a.youngsModulus * std::pow(b.youngsModulus / a.youngsModulus, part),
    a.poissonRatio + part * (b.poissonRatio - a.poissonRatio) };
}

/// Returns the most frequent material of a cell, into which the other materials are mixed one by
/// one.
ElasticMaterial mixTissues(std::vector<std::pair<double, ElasticMaterial>>& parts)
{
  std::stable_sort(
    parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  ElasticMaterial mixed = parts.front().second;
  double sum = parts.front().first;
  for (std::size_t i = 1; i < parts.size(); ++i)
  {
    sum += parts[i].first;
    const double share = parts[i].first / sum;
    mixed.youngsModulus = mixedModulus(mixed.youngsModulus, parts[i].second.youngsModulus, share);
    mixed.poissonRatio += share * (parts[i].second.poissonRatio - mixed.poissonRatio);
  }
  return mixed;
}

/// Collects the materials at the sample points of one cell.
class CellTissue
{
public:
  CellTissue(const ScanReader& scan, const TissueMap& map, bool labels, const ElasticMaterial& none)
    : Scan(scan)
    , Known(map)
    , HasLabels(labels)
    , Outside(none)
  {
  }

  void clear()
  {
    this->Volumes.clear();
    this->LogModulus = this->Ratio = this->All = 0.0;
    this->Fault.clear();
  }

  void add(const std::array<double, 3>& place, double volume)
  {
    double value = 0.0;
    const bool isInside = this->Scan.read(place, this->HasLabels, value);
    if (isInside && !std::isfinite(value))
    {
      this->Fault = joined("the image's value is ", value);
      return;
    }
    if (this->HasLabels)
    {
      const bool isKnown = !isInside || this->Known.count(value) > 0;
      if (!isKnown)
      {
        this->Fault = joined("label ", value, " is not among the Materials (AddMaterial)");
      }
      const double key = isInside ? value : std::numeric_limits<double>::infinity();
      this->Volumes[key] += isKnown ? volume : 0.0;
      return;
    }
    const ElasticMaterial here = isInside ? onScale(this->Known, value) : this->Outside;
    this->LogModulus += volume * std::log(here.youngsModulus);
    this->Ratio += volume * here.poissonRatio;
    this->All += volume;
  }

  ElasticMaterial material() const
  {
    if (!this->HasLabels)
    {
      return { std::exp(this->LogModulus / this->All), this->Ratio / this->All };
    }
    std::vector<std::pair<double, ElasticMaterial>> parts;
    for (const auto& [value, volume] : this->Volumes)
    {
      parts.emplace_back(volume, std::isfinite(value) ? this->Known.at(value) : this->Outside);
    }
    return mixTissues(parts);
  }

  const std::string& fault() const { return this->Fault; }

private:
  const ScanReader& Scan;
  const TissueMap& Known;
  bool HasLabels;
  ElasticMaterial Outside;
  /// Volume of each label. The key infinity represents the volume outside the image.
  std::map<double, double> Volumes;
  double LogModulus = 0.0;
  double Ratio = 0.0;
  double All = 0.0;
  std::string Fault;
};
} // namespace

std::string mapTissues(vtkUnstructuredGrid* grid, const TissueScan& scan,
  const WorkObserver& observer, vtkUnstructuredGrid* output)
{
  VolumeMesh ignored;
  std::string fault = convertVolume(grid, ignored);
  if (!fault.empty())
  {
    return fault;
  }
  const ScanReader reader(scan.image, scan.values);
  CellTissue tissue(reader, scan.map, scan.hasLabels, scan.outside);
  CellPlaces places(scan.subdivisions);
  const vtkIdType cells = grid->GetNumberOfCells();
  vtkNew<vtkDoubleArray> young;
  vtkNew<vtkDoubleArray> poisson;
  young->SetName("YoungsModulus");
  poisson->SetName("PoissonRatio");
  young->SetNumberOfTuples(cells);
  poisson->SetNumberOfTuples(cells);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    tissue.clear();
    places.visit(grid->GetCell(cell),
      [&tissue](const std::array<double, 3>& place, double volume) { tissue.add(place, volume); });
    if (!tissue.fault().empty())
    {
      return joined("Wrong input: in cell ", cell, " ", tissue.fault());
    }
    const ElasticMaterial material = tissue.material();
    young->SetValue(cell, material.youngsModulus);
    poisson->SetValue(cell, material.poissonRatio);
    if (cell % ScannedCellsPerAbortCheck == 0 && observer &&
      !observer(static_cast<double>(cell) / static_cast<double>(cells)))
    {
      return {};
    }
  }
  output->ShallowCopy(grid);
  output->GetCellData()->AddArray(young);
  output->GetCellData()->AddArray(poisson);
  return {};
}
} // namespace palpate
