// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoduleMaterial.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/ReducedModulus.h"
#include "Solids/TrueShape/InclusionMixing.h"
#include "SolidResponse/Bodies/FactorisedBody.h"
#include "SolidResponse/Bodies/FilledCells.h"
#include "SolidResponse/Bodies/VolumeConversion.h"
#include "Response/FilterStage.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace
{
constexpr vtkIdType CellsPerAbortCheck = 4096; // number of cells between checks for an abort
constexpr int MostSubdivisions = 64;

/// The output arrays.
struct MixedArrays
{
  vtkNew<vtkDoubleArray> Young;
  vtkNew<vtkDoubleArray> Poisson;
  vtkNew<vtkDoubleArray> YoungWithout;
  vtkNew<vtkDoubleArray> PoissonWithout;
  vtkNew<vtkDoubleArray> Fraction;

  void attach(vtkUnstructuredGrid* output, vtkIdType cells, bool before)
  {
    const std::array<std::pair<vtkDoubleArray*, const char*>, 5> all = {
      { { this->Young, "YoungsModulus" }, { this->Poisson, "PoissonRatio" },
        { this->YoungWithout, "YoungsModulusWithout" },
        { this->PoissonWithout, "PoissonRatioWithout" }, { this->Fraction, "NoduleFraction" } }
    };
    for (const auto& [array, name] : all)
    {
      if (before)
      {
        array->SetName(name);
        array->SetNumberOfTuples(cells);
      }
      else
      {
        output->GetCellData()->AddArray(array);
      }
    }
  }
};
} // namespace

vtkStandardNewMacro(vtkNoduleMaterial);

void vtkNoduleMaterial::AddNodule(double x, double y, double z, double radius, double youngsModulus)
{
  this->Nodules.push_back({ { x, y, z }, radius, youngsModulus, 0.0, false });
  this->Modified();
}

void vtkNoduleMaterial::AddNodule(
  double x, double y, double z, double radius, double youngsModulus, double poissonRatio)
{
  this->Nodules.push_back({ { x, y, z }, radius, youngsModulus, poissonRatio, true });
  this->Modified();
}

void vtkNoduleMaterial::ClearNodules()
{
  if (!this->Nodules.empty())
  {
    this->Nodules.clear();
    this->Modified();
  }
}

int vtkNoduleMaterial::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkNoduleMaterial::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(inputVector[0]);
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const std::string fault = palpate::firstFault([this] { return this->Check(); },
    [&] { return this->Mix(grid, vtkUnstructuredGrid::GetData(outputVector)); });
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

std::string vtkNoduleMaterial::Check()
{
  if (this->Subdivisions < 1 || this->Subdivisions > MostSubdivisions)
  {
    return palpate::joined("Sampling Points Per Side (Subdivisions) must be 1 to ",
      MostSubdivisions, ", but is ", this->Subdivisions);
  }
  for (std::size_t i = 0; i < this->Nodules.size(); ++i)
  {
    const Nodule& nodule = this->Nodules[i];
    const auto wrong = [i](const char* what, double value)
    { return palpate::joined("Nodule ", i, ": ", what, ", but is ", value); };
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (!std::isfinite(nodule.Middle[k]))
      {
        return wrong("its middle must be finite (mm)", nodule.Middle[k]);
      }
    }
    if (!(nodule.Radius > 0.0 && std::isfinite(nodule.Radius)))
    {
      return wrong("its radius must be positive and finite (mm)", nodule.Radius);
    }
    if (!palpate::isYoungsModulus(nodule.YoungsModulus))
    {
      return wrong("its Young's modulus must be positive and finite (MPa)", nodule.YoungsModulus);
    }
    if (nodule.HasPoissonRatio && !palpate::isElementRatio(nodule.PoissonRatio))
    {
      return wrong("its Poisson's ratio must lie between 0 and 0.499", nodule.PoissonRatio);
    }
  }
  return {};
}

double vtkNoduleMaterial::MixCell(
  const std::vector<double>& fractions, palpate::ElasticMaterial& material) const
{
  const double within = std::min(std::accumulate(fractions.begin(), fractions.end(), 0.0), 1.0);
  const double around = material.poissonRatio;
  // The nodules are mixed in one by one. The fraction of each nodule is relative to the volume that
  // has been mixed so far, including the nodule.
  double mixed = 1.0 - within;
  for (std::size_t i = 0; i < fractions.size(); ++i)
  {
    if (fractions[i] > 0.0)
    {
      const Nodule& nodule = this->Nodules[i];
      mixed += fractions[i];
      const double share = std::min(fractions[i] / mixed, 1.0);
      const double ratio = nodule.HasPoissonRatio ? nodule.PoissonRatio : around;
      material.youngsModulus =
        palpate::mixedModulus(material.youngsModulus, nodule.YoungsModulus, share);
      material.poissonRatio += share * (ratio - material.poissonRatio);
    }
  }
  return within;
}

std::string vtkNoduleMaterial::Mix(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* output)
{
  palpate::FactorRequest around;
  around.material = { this->YoungsModulus, this->PoissonRatio };
  const auto find = [this, grid](int index) { return this->GetInputArrayToProcess(index, grid); };
  palpate::VolumeMesh ignored;
  std::string fault = palpate::firstFault([&] { return palpate::checkFactorRequest(around); },
    [&] { return palpate::findCellArray(this, grid, 0, find, around.young); },
    [&] { return palpate::findCellArray(this, grid, 1, find, around.poisson); },
    [&] { return palpate::convertVolume(grid, ignored); });
  if (!fault.empty())
  {
    return fault;
  }
  std::vector<palpate::BodyBall> balls;
  for (const Nodule& nodule : this->Nodules)
  {
    balls.push_back({ nodule.Middle, nodule.Radius });
  }
  palpate::FilledCells filled(balls, this->Subdivisions);
  std::vector<bool> isFilling(balls.size(), false);
  const vtkIdType cells = grid->GetNumberOfCells();
  const std::vector<palpate::ElasticMaterial> without =
    palpate::convertMaterials(cells, around.young, around.poisson, around.material);
  MixedArrays arrays;
  arrays.attach(output, cells, true);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const palpate::ElasticMaterial& base =
      without.size() == 1 ? without.front() : without[static_cast<std::size_t>(cell)];
    if (!palpate::isYoungsModulus(base.youngsModulus) ||
      !palpate::isElementRatio(base.poissonRatio))
    {
      return palpate::joined("Wrong input: cell ", cell, " has Young's modulus ",
        base.youngsModulus, " MPa and Poisson's ratio ", base.poissonRatio);
    }
    palpate::ElasticMaterial mixed = base;
    double within = 0.0;
    if (const std::vector<double>* fractions = filled.fractions(grid, cell))
    {
      within = this->MixCell(*fractions, mixed);
      for (std::size_t i = 0; i < fractions->size(); ++i)
      {
        isFilling[i] = isFilling[i] || (*fractions)[i] > 0.0;
      }
    }
    arrays.Young->SetValue(cell, mixed.youngsModulus);
    arrays.Poisson->SetValue(cell, mixed.poissonRatio);
    arrays.YoungWithout->SetValue(cell, base.youngsModulus);
    arrays.PoissonWithout->SetValue(cell, base.poissonRatio);
    arrays.Fraction->SetValue(cell, within);
    if (cell % CellsPerAbortCheck == 0 &&
      !palpate::FilterStage{ this, 0.0, 1.0 }(
        static_cast<double>(cell) / static_cast<double>(cells)))
    {
      return {};
    }
  }
  const auto lost = std::find(isFilling.begin(), isFilling.end(), false);
  if (lost != isFilling.end())
  {
    const auto i = static_cast<std::size_t>(lost - isFilling.begin());
    const Nodule& nodule = this->Nodules[i];
    return palpate::joined("Nodule ", i, ", radius ", nodule.Radius, " mm at ", nodule.Middle[0],
      ", ", nodule.Middle[1], ", ", nodule.Middle[2],
      " mm, fills no part of any cell: it lies outside, or under others, or between the "
      "sampling points of a cell");
  }
  output->ShallowCopy(grid);
  arrays.attach(output, cells, false);
  this->UpdateProgress(1.0);
  return {};
}

void vtkNoduleMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "Nodules: " << this->Nodules.size() << "\n";
  os << indent << "Subdivisions: " << this->Subdivisions << "\n";
}
