// SPDX-License-Identifier: BSD-3-Clause
#include "SolidResponse/Bodies/RestOfBody.h"

#include "vtkGenericCell.h"

#include <algorithm>
#include <limits>

namespace palpate
{
std::string RestOfBody::factorise(vtkUnstructuredGrid* grid, const FactorRequest& request,
  const std::function<bool(double)>& goOn, double& memory, bool& ended)
{
  this->Grid->CopyStructure(grid);
  this->Locator->SetDataSet(this->Grid);
  this->Locator->BuildLocator();
  return factoriseBody(grid, request, goOn, this->Body, memory, ended);
}

double RestOfBody::spacing() const
{
  const BodySurface& surface = this->Body.surface();
  double sum = 0.0;
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    sum += surface.spacing(i) / surface.pointTotal();
  }
  return sum;
}

std::int32_t RestOfBody::nearestPoint(
  const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const
{
  const BodySurface& surface = this->Body.surface();
  std::int32_t found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::int32_t i = 0; i < surface.pointTotal(); ++i)
  {
    const double square = (surface.position(i) - place).squaredNorm();
    if (square < least && surface.normal(i).dot(normal) > 0.0)
    {
      least = square;
      found = i;
    }
  }
  return found;
}

ElementPlace RestOfBody::locate(
  const Eigen::Vector3d& place, vtkGenericCell* cell, std::vector<double>& shapes) const
{
  Eigen::Vector3d from = place;
  Eigen::Vector3d closest;
  Eigen::Vector3d own;
  vtkIdType id = -1;
  int part = 0;
  double square = 0.0;
  this->Locator->FindClosestPoint(from.data(), closest.data(), cell, id, part, square);
  this->Grid->GetCell(id, cell);
  cell->EvaluatePosition(closest.data(), nullptr, part, own.data(), square, shapes.data());
  const ElementKind kind = this->Body.mesh().elements[static_cast<std::size_t>(id)].kind;
  const bool isHexahedron = kind == ElementKind::Hexahedron;
  return { static_cast<std::int32_t>(id),
    isHexahedron ? Eigen::Vector3d(2.0 * own.array() - 1.0) : own };
}

UnitMotion RestOfBody::motionAt(const Eigen::Vector3d& place, const Eigen::Vector3d& inward,
  const Eigen::Matrix3Xd& places, const std::vector<unsigned char>& asked) const
{
  vtkNew<vtkGenericCell> cell;
  std::vector<double> shapes(static_cast<std::size_t>(LargestNodeCount));
  const UnitMotion all = unitMotion(this->Body, place, this->locate(place + inward, cell, shapes));
  UnitMotion found;
  found.about = place;
  if (all.nodes.front().size() == 0)
  {
    return found;
  }
  for (Eigen::Matrix3Xd& moved : found.nodes)
  {
    moved.setZero(3, places.cols());
  }
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    if (!asked[static_cast<std::size_t>(i)])
    {
      continue;
    }
    this->locate(places.col(i), cell, shapes);
    for (std::size_t k = 0; k < found.nodes.size(); ++k)
    {
      for (vtkIdType n = 0; n < cell->GetNumberOfPoints(); ++n)
      {
        found.nodes[k].col(i) +=
          shapes[static_cast<std::size_t>(n)] * all.nodes[k].col(cell->GetPointId(n));
      }
    }
  }
  return found;
}
} // namespace palpate
