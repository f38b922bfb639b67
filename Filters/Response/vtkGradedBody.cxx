// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGradedBody.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "Response/Bodies/ClosedSurface.h"
#include "Response/FilterStage.h"
#include "Response/Mesher/CurvedTetrahedra.h"
#include "Response/Mesher/SurfaceMesher.h"
#include "Response/Mesher/SurfaceRepair.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkFeatureEdges.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double InteriorRatio = 4.0;
constexpr double DeviationRatio = 0.05;
constexpr double LargestGrowth = 2.0;

/// Cells per cube of the spacing, and the peak memory per cell; measured on balls.
constexpr double CellsPerCube = 8.7;
constexpr double BytesPerCell = 2000.0;
/// Cells have ten nodes each, numbered by 32 bits.
constexpr double MostCells = std::numeric_limits<std::int32_t>::max() / 10.0;

/// Facets cut off about a hundredth of the volume; a larger loss is a part of the body.
constexpr double LostVolume = 0.1;
constexpr double MeshedShare = 0.9; // of the work
constexpr double RoughStep = 3.0;   // of the deviation, where a surface is too rough for it

/// For a body of given volume and area whose spacing grows from s to l inwards.
double expectedCells(const palpate::ClosedSurface& closed, double s, double l, double growth)
{
  const double graded =
    closed.area * (1.0 / (s * s) - 1.0 / (l * l)) / (2.0 * growth) + closed.volume / std::pow(l, 3);
  return CellsPerCube * std::min(graded, closed.volume / std::pow(s, 3));
}

/// For a finer ball, and for the shell in which the spacing u grows from s to l: cells of u³ at
/// r = R + (u - s)/growth.
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

/// The closest point of lines or triangles.
class ClosestPlace
{
public:
  explicit ClosestPlace(vtkPolyData* data)
    : IsEmpty(data->GetNumberOfCells() == 0)
  {
    if (!this->IsEmpty)
    {
      this->Locator->SetDataSet(data);
      this->Locator->BuildLocator();
    }
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& place) const
  {
    Eigen::Vector3d at = place;
    if (!this->IsEmpty)
    {
      Eigen::Vector3d from = place;
      vtkIdType id = -1;
      int part = 0;
      double square = 0.0;
      this->Locator->FindClosestPoint(from.data(), at.data(), this->Cell, id, part, square);
    }
    return at;
  }

private:
  bool IsEmpty;
  vtkNew<vtkStaticCellLocator> Locator;
  vtkNew<vtkGenericCell> Cell;
};

palpate::MeshedSurface convertSurfaceToMesh(vtkPolyData* surface)
{
  palpate::MeshedSurface made;
  made.points.resize(3, surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, made.points.col(i).data());
  }
  vtkNew<vtkIdList> ids;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(ids);)
  {
    made.triangles.push_back({ static_cast<std::int32_t>(ids->GetId(0)),
      static_cast<std::int32_t>(ids->GetId(1)), static_cast<std::int32_t>(ids->GetId(2)) });
  }
  return made;
}

vtkSmartPointer<vtkPolyData> convertMeshToSurface(const palpate::MeshedSurface& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.points.cols());
  for (Eigen::Index i = 0; i < mesh.points.cols(); ++i)
  {
    points->SetPoint(i, mesh.points.col(i).data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const std::array<vtkIdType, 3> corners = { a, b, c };
    triangles->InsertNextCell(3, corners.data());
  }
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

double volumeOf(const palpate::TetrahedralMesh& mesh)
{
  double volume = 0.0;
  for (const auto& cell : mesh.cells)
  {
    Eigen::Matrix3d sides;
    for (int i = 0; i < 3; ++i)
    {
      sides.col(i) =
        mesh.nodes.col(cell[static_cast<std::size_t>(i) + 1]) - mesh.nodes.col(cell[0]);
    }
    volume += sides.determinant() / 6.0;
  }
  return volume;
}

void convertTetrahedra(const palpate::CurvedTetrahedra& curved, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  points->SetNumberOfPoints(curved.nodes.cols());
  for (vtkIdType i = 0; i < curved.nodes.cols(); ++i)
  {
    points->SetPoint(i, curved.nodes.col(i).data());
  }
  vtkNew<vtkCellArray> cells;
  const auto count = static_cast<vtkIdType>(curved.cells.size());
  cells->AllocateExact(count, 10 * count);
  for (const auto& cell : curved.cells)
  {
    std::array<vtkIdType, 10> ids{};
    std::copy(cell.begin(), cell.end(), ids.begin());
    cells->InsertNextCell(10, ids.data());
  }
  output->SetPoints(points);
  output->SetCells(VTK_QUADRATIC_TETRA, cells);
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

/// The surface, closed if it is nearly so.
std::string vtkGradedBody::TakeSurface(vtkPolyData* body, palpate::ClosedSurface& closed)
{
  const std::string fault = palpate::takeClosedSurface(body, closed);
  if (fault.empty() || !closed.isOpen)
  {
    return fault;
  }
  palpate::MeshedSurface surface = convertSurfaceToMesh(closed.surface);
  palpate::ClosedUp done;
  const std::string open = palpate::closeSurface(surface, done);
  if (!open.empty())
  {
    return fault + " (" + open + ")";
  }
  vtkWarningMacro(<< "The surface was not closed: it was parted at " << done.points
                  << " points where it touched itself, and " << done.holes
                  << " holes were filled, the widest " << done.widest << " mm.");
  closed = {};
  return palpate::takeClosedSurface(convertMeshToSurface(surface), closed);
}

std::string vtkGradedBody::Fill(vtkPolyData* body, vtkUnstructuredGrid* output)
{
  palpate::HeldFaces faces{};
  palpate::ClosedSurface closed;
  std::string fault = palpate::readHeldFaces(this->FixedFaces, 0.5 * this->SurfaceSpacing, faces);
  fault = fault.empty() ? this->TakeSurface(body, closed) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  const double inside =
    this->InteriorSpacing > 0.0 ? this->InteriorSpacing : InteriorRatio * this->SurfaceSpacing;
  this->CellEstimate = expectedCells(closed, this->SurfaceSpacing, inside, this->Growth);
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
  palpate::MeshedSurface wanted = convertSurfaceToMesh(closed.surface);
  std::size_t mended = 0;
  fault = palpate::mendSurface(wanted, mended);
  if (!fault.empty())
  {
    return "Wrong input: " + fault;
  }
  if (mended > 0)
  {
    vtkWarningMacro(<< "The surface cut itself at " << mended
                    << " pairs of triangles; it was mended there before it was filled.");
  }
  wanted.spacing.assign(static_cast<std::size_t>(wanted.points.cols()), this->SurfaceSpacing);
  wanted.balls = balls;
  wanted.interiorSpacing = inside;
  wanted.growth = this->Growth;
  wanted.deviation =
    this->Deviation > 0.0 ? this->Deviation : DeviationRatio * this->SurfaceSpacing;
  palpate::TetrahedralMesh mesh;
  do
  {
    fault = palpate::fillSurface(
      wanted, this->CellEstimate, palpate::FilterStage{ this, 0.0, MeshedShare }, mesh);
    wanted.deviation *= mesh.isTooRough && !wanted.isManifold ? RoughStep : 1.0;
    wanted.isManifold = wanted.isManifold && !mesh.isTooRough;
  } while (mesh.isTooRough && wanted.deviation < this->SurfaceSpacing);
  if (mesh.isTooRough)
  {
    return palpate::joined("The surface is rougher than SurfaceSpacing ", this->SurfaceSpacing,
      " mm can follow: smooth it, or give a larger one");
  }
  if (!fault.empty() || palpate::isAborted(this))
  {
    return fault.empty() ? fault : "Wrong input: " + fault;
  }
  const double volume = volumeOf(mesh);
  if (!(std::abs(volume / closed.volume - 1.0) < LostVolume))
  {
    return palpate::joined("The tetrahedra fill ", volume, " of the ", closed.volume,
      " mm³ inside the surface: SurfaceSpacing ", this->SurfaceSpacing,
      " mm is too coarse for some part of it");
  }
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(closed.surface);
  edges->SetFeatureAngle(wanted.sharpAngle);
  edges->BoundaryEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  const ClosestPlace onSurface(closed.surface);
  const ClosestPlace onEdge(edges->GetOutput());
  const palpate::CurvedTetrahedra curved = palpate::curveTetrahedra(mesh,
    [&](const Eigen::Vector3d& middle, bool isSharp)
    { return isSharp ? onEdge(middle) : onSurface(middle); });
  convertTetrahedra(curved, output);
  output->GetPointData()->AddArray(palpate::holdFaces(curved.nodes, faces));
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
