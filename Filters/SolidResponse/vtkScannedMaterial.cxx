// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScannedMaterial.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Mechanics/ReducedModulus.h"
#include "Response/FilterStage.h"
#include "SolidResponse/Bodies/FactorisedBody.h"
#include "SolidResponse/Bodies/TissueCells.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
constexpr int MostPlaces = 64;
} // namespace

vtkStandardNewMacro(vtkScannedMaterial);

vtkScannedMaterial::vtkScannedMaterial()
{
  this->SetNumberOfInputPorts(2);
}

void vtkScannedMaterial::SetImageConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkScannedMaterial::SetImageData(vtkImageData* image)
{
  this->SetInputData(1, image);
}

void vtkScannedMaterial::AddMaterial(double value, double youngsModulus, double poissonRatio)
{
  this->Rows.push_back({ value, youngsModulus, poissonRatio });
  this->Modified();
}

void vtkScannedMaterial::ClearMaterials()
{
  if (!this->Rows.empty())
  {
    this->Rows.clear();
    this->Modified();
  }
}

int vtkScannedMaterial::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 1 ? "vtkImageData" : "vtkUnstructuredGrid");
  return 1;
}

int vtkScannedMaterial::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(inputVector[0]);
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const std::string fault = palpate::firstFault([this] { return this->CheckMap(); },
    [&]
    {
      return this->Map(
        grid, vtkImageData::GetData(inputVector[1]), vtkUnstructuredGrid::GetData(outputVector));
    });
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

std::string vtkScannedMaterial::CheckMap()
{
  if (this->Subdivisions < 1 || this->Subdivisions > MostPlaces)
  {
    return palpate::joined("Sampling Points Per Side (Subdivisions) must be 1 to ", MostPlaces,
      ", but is ", this->Subdivisions);
  }
  palpate::FactorRequest outside;
  outside.material = { this->YoungsModulus, this->PoissonRatio };
  const std::string fault = palpate::checkFactorRequest(outside);
  if (!fault.empty())
  {
    return fault;
  }
  if (this->Rows.empty())
  {
    return "Materials are required, a row for each value of the image (AddMaterial)";
  }
  for (std::size_t i = 0; i < this->Rows.size(); ++i)
  {
    const Row& row = this->Rows[i];
    const auto wrong = [i](const char* what, double value)
    { return palpate::joined("Material ", i, ": ", what, ", but is ", value); };
    if (!std::isfinite(row.Value))
    {
      return wrong("its value must be finite", row.Value);
    }
    if (!palpate::isYoungsModulus(row.YoungsModulus))
    {
      return wrong("its Young's modulus must be positive and finite (MPa)", row.YoungsModulus);
    }
    if (!palpate::isElementRatio(row.PoissonRatio))
    {
      return wrong("its Poisson's ratio must lie between 0 and 0.499", row.PoissonRatio);
    }
    for (std::size_t k = 0; k < i; ++k)
    {
      if (this->Rows[k].Value == row.Value)
      {
        return palpate::joined("Materials ", k, " and ", i, " have the same value, ", row.Value);
      }
    }
  }
  return {};
}

std::string vtkScannedMaterial::Map(
  vtkUnstructuredGrid* grid, vtkImageData* image, vtkUnstructuredGrid* output)
{
  vtkInformationVector* wanted = this->GetInformation()->Get(INPUT_ARRAYS_TO_PROCESS());
  vtkDataArray* values = !image || image->GetNumberOfPoints() == 0 ? nullptr
    : wanted && wanted->GetNumberOfInformationObjects() > 0 ? this->GetInputArrayToProcess(0, image)
                                                            : image->GetPointData()->GetScalars();
  if (!values || values->GetNumberOfComponents() != 1 ||
    values->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return "Wrong input: the image has no point array of one component";
  }
  palpate::TissueScan scan{ image, values, {}, this->Labels,
    { this->YoungsModulus, this->PoissonRatio }, this->Subdivisions };
  for (const Row& row : this->Rows)
  {
    scan.map[row.Value] = { row.YoungsModulus, row.PoissonRatio };
  }
  const std::string fault =
    palpate::mapTissues(grid, scan, palpate::FilterStage{ this, 0.0, 1.0 }, output);
  if (!fault.empty() || palpate::isAborted(this))
  {
    return fault;
  }
  this->UpdateProgress(1.0);
  return {};
}

void vtkScannedMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Materials: " << this->Rows.size() << "\n";
  os << indent << "Labels: " << this->Labels << "\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "Subdivisions: " << this->Subdivisions << "\n";
}
