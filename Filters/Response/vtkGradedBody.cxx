// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGradedBody.h"

#include "Mechanics/JoinedText.h"
#include "Mechanics/Numerics/AvailableMemory.h"
#include "Response/Bodies/ClosedSurface.h"
#include "Response/FilterStage.h"
#include "Response/Mesher/MeshConversion.h"
#include "Response/Mesher/OutsideReach.h"
#include "Response/Mesher/SurfaceCut.h"
#include "Response/Mesher/SurfaceMesher.h"
#include "Response/Mesher/SurfaceRepair.h"

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

#include <Eigen/LU>

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

/// Cells per cube of the spacing, and the peak memory per cell; measured on balls.
constexpr double CellsPerCube = 8.7;
constexpr double BytesPerCell = 2000.0;
/// Cells have ten nodes each, numbered by 32 bits.
constexpr double MostCells = std::numeric_limits<std::int32_t>::max() / 10.0;

/// Facets cut off about a hundredth of the volume; a larger loss is a part of the body.
constexpr double LostVolume = 0.1;
/// Parts that a cut leaves are left out below the cube of this, in spacings.
constexpr double LeastPart = 0.5;
constexpr double OnCut = 1e-6;      // of the spacing
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
  palpate::MeshedSurface surface = palpate::convertSurfaceToMesh(closed.surface);
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
  return palpate::takeClosedSurface(palpate::convertMeshToSurface(surface), closed);
}

/// Cuts off what is held to a given depth, so that it ends there and not at the next cell. Returns
/// the planes; none where the surface cannot be cut.
std::vector<palpate::CutPlane> vtkGradedBody::CutHeld(
  palpate::HeldFaces& faces, palpate::MeshedSurface& wanted, palpate::ClosedSurface& closed)
{
  std::vector<palpate::CutPlane> planes;
  const Eigen::Vector3d lowest = wanted.points.rowwise().minCoeff();
  const Eigen::Vector3d highest = wanted.points.rowwise().maxCoeff();
  for (std::size_t side = 0; side < faces.size(); ++side)
  {
    const auto axis = static_cast<Eigen::Index>(side / 2);
    const bool isUpper = side % 2 == 1;
    if (faces[side].isGiven)
    {
      planes.push_back({ axis, isUpper,
        isUpper ? highest[axis] - faces[side].depth : lowest[axis] + faces[side].depth });
    }
  }
  if (planes.empty())
  {
    return planes;
  }
  palpate::MeshedSurface left = wanted;
  palpate::ClosedSurface closedLeft;
  std::string fault = palpate::cutOff(left, planes, std::pow(LeastPart * this->SurfaceSpacing, 3));
  fault = fault.empty()
    ? palpate::takeClosedSurface(palpate::convertMeshToSurface(left), closedLeft)
    : fault;
  if (!fault.empty())
  {
    vtkWarningMacro(<< "What is held ends at whole cells, since " << fault << ".");
    return {};
  }
  wanted = std::move(left);
  closed = closedLeft;
  for (palpate::HeldFace& face : faces)
  {
    face.depth = face.isGiven ? OnCut * this->SurfaceSpacing : face.depth;
  }
  return planes;
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
  palpate::MeshedSurface wanted = palpate::convertSurfaceToMesh(closed.surface);
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
  const std::vector<palpate::CutPlane> cuts = this->CutHeld(faces, wanted, closed);
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
  const palpate::CurvedTetrahedra curved =
    palpate::curveTetrahedra(mesh, palpate::outsideReach(closed.surface, wanted, cuts));
  palpate::convertTetrahedra(curved, output);
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
