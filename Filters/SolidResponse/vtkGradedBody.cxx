// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGradedBody.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "Response/FilterStage.h"
#include "SolidResponse/Mesher/MeshConversion.h"
#include "SolidResponse/Mesher/PreparedSurface.h"
#include "SolidResponse/Mesher/SurfaceMesher.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{
constexpr double InteriorRatio = 4.0;
constexpr double DeviationRatio = 0.05;
constexpr double LargestGrowth = 2.0;

/// Cells per cube of the spacing, and peak memory per cell; measured on balls.
constexpr double CellsPerCube = 8.7;
constexpr double BytesPerCell = 2000.0;
/// Cells have ten nodes each, numbered by 32 bits.
constexpr double MostCells = std::numeric_limits<std::int32_t>::max() / 10.0;

constexpr double MeshedShare = 0.9; // fraction of the work

/// Expected cells of a body of given volume and area whose spacing grows from s to l inwards.
double expectedCells(const palpate::ClosedSurface& closed, double s, double l, double growth)
{
  const double graded =
    closed.area * (1.0 / (s * s) - 1.0 / (l * l)) / (2.0 * growth) + closed.volume / std::pow(l, 3);
  return CellsPerCube * std::min(graded, closed.volume / std::pow(s, 3));
}

/// Expected cells of a finer ball and of the shell in which the spacing u grows from s to l: cells
/// of u³ at r = R + (u - s)/growth.
double expectedCells(const palpate::FineBall& ball, double l, double growth)
{
  const double s = std::min(ball.spacing, l);
  const double b = growth * ball.radius - s;
  const auto primitive = [b](double u)
  { return std::log(u) - 2.0 * b / u - 0.5 * b * b / (u * u); };
  const double inside = std::pow(ball.radius / s, 3) / 3.0;
  const double around = (primitive(l) - primitive(s)) / std::pow(growth, 3);
  return CellsPerCube * 4.0 * vtkMath::Pi() * (inside + around);
}
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
  if (!body || body->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  std::string fault = this->CheckProperties();
  fault = fault.empty() ? this->Fill(body, vtkUnstructuredGrid::GetData(outputVector)) : fault;
  if (!fault.empty())
  {
    vtkErrorMacro(<< fault << ".");
    return 0;
  }
  return 1;
}

std::string vtkGradedBody::CheckProperties() const
{
  if (!(this->SurfaceSpacing > 0.0 && std::isfinite(this->SurfaceSpacing)))
  {
    return palpate::joined(
      "SurfaceSpacing must be positive and finite (mm), but is ", this->SurfaceSpacing);
  }
  const double inside = this->InteriorSpacing;
  if (!(inside == 0.0 || (inside >= this->SurfaceSpacing && std::isfinite(inside))))
  {
    return palpate::joined("InteriorSpacing must be 0 or at least SurfaceSpacing, ",
      this->SurfaceSpacing, " mm, but is ", inside);
  }
  if (!(this->Growth > 0.0 && this->Growth <= LargestGrowth))
  {
    return palpate::joined(
      "Growth must be positive and at most ", LargestGrowth, ", but is ", this->Growth);
  }
  if (!(this->Deviation >= 0.0 && std::isfinite(this->Deviation)))
  {
    return palpate::joined("Deviation must be 0 or positive (mm), but is ", this->Deviation);
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
  palpate::HeldFaces faces{};
  palpate::PreparedSurface prepared;
  std::string fault = palpate::readHeldFaces(this->FixedFaces, 0.5 * this->SurfaceSpacing, faces);
  fault = fault.empty() ? palpate::takeSurface(body, prepared) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  const double inside =
    this->InteriorSpacing > 0.0 ? this->InteriorSpacing : InteriorRatio * this->SurfaceSpacing;
  this->CellEstimate = expectedCells(prepared.closed, this->SurfaceSpacing, inside, this->Growth);
  std::vector<palpate::FineBall> balls;
  for (const auto& [x, y, z, radius, spacing] : this->FineBalls)
  {
    balls.push_back({ Eigen::Vector3d(x, y, z), radius, spacing });
    this->CellEstimate += expectedCells(balls.back(), this->SurfaceSpacing, this->Growth);
  }
  const double needed = BytesPerCell * this->CellEstimate;
  const double available = palpate::availableMemory();
  if (!(this->CellEstimate < MostCells) || needed > available)
  {
    return palpate::joined("SurfaceSpacing ", this->SurfaceSpacing, " mm",
      balls.empty() ? "" : " with its FineBalls", " makes about ", this->CellEstimate,
      " tetrahedra, which need about ", needed / palpate::Mebibyte, " MiB, but ",
      available / palpate::Mebibyte, " MiB are available, and more than ", MostCells,
      " are too many");
  }
  fault = palpate::mendAndCut(this->SurfaceSpacing, faces, prepared);
  for (const std::string& warning : prepared.warnings)
  {
    vtkWarningMacro(<< warning);
  }
  if (!fault.empty())
  {
    return fault;
  }
  palpate::MeshedSurface& wanted = prepared.wanted;
  wanted.spacing.assign(static_cast<std::size_t>(wanted.points.cols()), this->SurfaceSpacing);
  wanted.balls = balls;
  wanted.interiorSpacing = inside;
  wanted.growth = this->Growth;
  wanted.deviation =
    this->Deviation > 0.0 ? this->Deviation : DeviationRatio * this->SurfaceSpacing;
  palpate::CurvedTetrahedra curved;
  fault = palpate::fillPrepared(prepared, this->SurfaceSpacing, this->CellEstimate,
    palpate::FilterStage{ this, 0.0, MeshedShare }, curved);
  if (!fault.empty() || palpate::isAborted(this))
  {
    return fault;
  }
  palpate::convertTetrahedra(curved, output);
  output->GetPointData()->AddArray(palpate::holdFaces(output, faces));
  this->UpdateProgress(1.0);
  return {};
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
  os << indent << "CellEstimate: " << this->CellEstimate << "\n";
}
