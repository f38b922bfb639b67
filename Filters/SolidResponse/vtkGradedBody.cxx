// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGradedBody.h"

#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "Response/FilterStage.h"
#include "SolidResponse/Mesher/GradedFilling.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
constexpr double LargestGrowth = 2.0;
} // namespace

vtkStandardNewMacro(vtkGradedBody);

bool vtkGradedBody::IsAvailable()
{
  return palpate::hasSurfaceMesher();
}

void vtkGradedBody::AddFineBall(double x, double y, double z, double radius, double spacing)
{
  this->FineBalls.push_back({ x, y, z, radius, spacing });
  this->Modified();
}

void vtkGradedBody::ClearFineBalls()
{
  if (!this->FineBalls.empty())
  {
    this->FineBalls.clear();
    this->Modified();
  }
}

int vtkGradedBody::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkGradedBody::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  this->CellEstimate = 0.0;
  this->UsedSpacing = 0.0;
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const std::string fault = palpate::firstFault([this] { return this->CheckProperties(); },
    [&] { return this->Fill(body, vtkUnstructuredGrid::GetData(outputVector)); });
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

std::string vtkGradedBody::CheckProperties() const
{
  if (!(this->SurfaceSpacing >= 0.0 && std::isfinite(this->SurfaceSpacing)))
  {
    return palpate::joined(
      "Surface Spacing must be 0 or positive, and finite (mm), but is ", this->SurfaceSpacing);
  }
  const double inside = this->InteriorSpacing;
  if (!(inside >= 0.0 && std::isfinite(inside)))
  {
    return palpate::joined(
      "Interior Spacing must be 0 or positive, and finite (mm), but is ", inside);
  }
  if (!(this->Growth > 0.0 && this->Growth <= LargestGrowth))
  {
    return palpate::joined("Growth Of Cells Inwards (Growth) must be positive and at most ",
      LargestGrowth, ", but is ", this->Growth);
  }
  if (!(this->Deviation >= 0.0 && std::isfinite(this->Deviation)))
  {
    return palpate::joined(
      "Largest Deviation From Surface (Deviation) must be 0 or positive (mm), but is ",
      this->Deviation);
  }
  for (std::size_t i = 0; i < this->FineBalls.size(); ++i)
  {
    const auto& [x, y, z, radius, spacing] = this->FineBalls[i];
    if (!std::isfinite(x + y + z))
    {
      return palpate::joined(
        "FineBall ", i, ": its middle must be finite (mm), but is ", x, ", ", y, ", ", z);
    }
    if (!(radius >= 0.0 && std::isfinite(radius)))
    {
      return palpate::joined(
        "FineBall ", i, ": its radius must be 0 or positive (mm), but is ", radius);
    }
    if (!(spacing > 0.0 && std::isfinite(spacing)))
    {
      return palpate::joined(
        "FineBall ", i, ": its spacing must be positive and finite (mm), but is ", spacing);
    }
  }
  return {};
}

std::string vtkGradedBody::Fill(vtkPolyData* body, vtkUnstructuredGrid* output)
{
  palpate::GradedCells cells{ this->SurfaceSpacing, this->InteriorSpacing, this->Growth,
    this->Deviation, {}, this->FixedFaces };
  for (const auto& [x, y, z, radius, spacing] : this->FineBalls)
  {
    cells.balls.push_back({ Eigen::Vector3d(x, y, z), radius, spacing });
  }
  palpate::GradedReport report;
  std::string fault =
    palpate::fillGraded(body, cells, palpate::FilterStage{ this, 0.0, 1.0 }, output, report);
  this->CellEstimate = report.cells;
  this->UsedSpacing = report.spacing;
  for (const std::string& warning : report.warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (fault.empty() && !palpate::isAborted(this))
  {
    this->UpdateProgress(1.0);
  }
  return fault;
}

void vtkGradedBody::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceSpacing: " << this->SurfaceSpacing << " mm\n";
  os << indent << "InteriorSpacing: " << this->InteriorSpacing << " mm\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "FineBalls: " << this->FineBalls.size() << "\n";
  os << indent << "Deviation: " << this->Deviation << " mm\n";
  os << indent << "FixedFaces: " << this->FixedFaces << "\n";
  os << indent << "UsedSpacing: " << this->UsedSpacing << " mm\n";
  os << indent << "CellEstimate: " << this->CellEstimate << "\n";
}
