// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPressPath.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using Vector = Eigen::Vector3d;

namespace
{
constexpr double StepAngle = 0.25 * 3.14159265358979323846 / 180.0;
constexpr double LargestLeap = 10.0; // largest distance between neighbouring points, mm
constexpr double RestTime = 0.25;    // time of rest after pressing and before lifting, s
// As a fraction of the body's size. The tolerance makes a ray through an edge hit the edge.
constexpr double EdgeTolerance = 1e-8;

/// Returns the unit directions of the path, which are the given directions and intermediate
/// directions in equal steps.
std::vector<Vector> sweep(const std::vector<std::array<double, 3>>& given)
{
  std::vector<Vector> directions;
  for (const auto& next : given)
  {
    const Vector to = Vector(next[0], next[1], next[2]).normalized();
    if (!directions.empty())
    {
      const Vector from = directions.back();
      const auto turn = Eigen::Quaterniond::FromTwoVectors(from, to);
      const int steps =
        std::max(1, static_cast<int>(std::ceil(Eigen::AngleAxisd(turn).angle() / StepAngle)));
      for (int i = 1; i < steps; ++i)
      {
        const double share = static_cast<double>(i) / steps;
        directions.push_back(Eigen::Quaterniond::Identity().slerp(share, turn) * from);
      }
    }
    directions.push_back(to);
  }
  return directions;
}
} // namespace

/// A point of the surface along the path.
struct vtkPressPath::Footprint
{
  Vector point;
  Vector normal;
  double along; ///< length of the path up to this point, mm
};

vtkStandardNewMacro(vtkPressPath);

void vtkPressPath::AddDirection(double x, double y, double z)
{
  this->Directions.push_back({ x, y, z });
  this->Modified();
}

void vtkPressPath::RemoveAllDirections()
{
  this->Directions.clear();
  this->Modified();
}

int vtkPressPath::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* body = vtkPolyData::GetData(inputVector[0]);
  if (!body || body->GetNumberOfCells() == 0 || this->Directions.empty())
  {
    vtkErrorMacro(<< "A body with triangles and at least one direction are required.");
    return 0;
  }
  if (!(this->PressSpeed > 0.0 && this->SlideSpeed > 0.0 && std::isfinite(this->Depth) &&
        this->SmoothingLength >= 0.0 && this->Approach >= 0.0))
  {
    vtkErrorMacro(<< "PressSpeed and SlideSpeed must be positive, SmoothingLength and Approach "
                     "not negative, Depth finite.");
    return 0;
  }
  std::vector<Footprint> footprints;
  if (!this->FindFootprints(body, footprints))
  {
    return 0;
  }
  this->SmoothNormals(footprints);
  this->WritePath(footprints, vtkPolyData::GetData(outputVector));
  return 1;
}

bool vtkPressPath::FindFootprints(vtkPolyData* body, std::vector<Footprint>& footprints)
{
  vtkNew<vtkPolyData> shallow; // a copy, because a locator builds links in it
  shallow->ShallowCopy(body);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(shallow);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  const Vector center(this->Center);
  const double tolerance = EdgeTolerance * body->GetLength();
  const double reach = 2.0 * body->GetLength() + (center - Vector(body->GetCenter())).norm();
  for (const Vector& direction : sweep(this->Directions))
  {
    const Vector outside = center + reach * direction;
    Footprint foot{ Vector::Zero(), Vector::Zero(), 0.0 };
    double t = 0.0;
    double parametric[3];
    int subId = 0;
    vtkIdType hit = -1;
    if (!direction.allFinite() ||
      !locator->IntersectWithLine(outside.data(), center.data(), tolerance, t, foot.point.data(),
        parametric, subId, hit, cell))
    {
      vtkErrorMacro(<< "Direction (" << direction.x() << ", " << direction.y() << ", "
                    << direction.z() << ") from (" << center.x() << ", " << center.y() << ", "
                    << center.z() << ") meets no surface.");
      return false;
    }
    double corner[3][3];
    for (vtkIdType k = 0; k < 3; ++k)
    {
      cell->GetPoints()->GetPoint(k, corner[k]);
    }
    vtkTriangle::ComputeNormal(corner[0], corner[1], corner[2], foot.normal.data());
    if (foot.normal.dot(direction) < 0.0)
    {
      // Turn the normal outward, because the ray comes from outside the body.
      foot.normal = -foot.normal;
    }
    if (!footprints.empty())
    {
      const double leap = (foot.point - footprints.back().point).norm();
      if (leap > LargestLeap)
      {
        vtkErrorMacro(<< "The path jumps " << leap << " mm at direction (" << direction.x() << ", "
                      << direction.y() << ", " << direction.z()
                      << "): it crosses a gap or a silhouette.");
        return false;
      }
      foot.along = footprints.back().along + leap;
    }
    footprints.push_back(foot);
  }
  return true;
}

void vtkPressPath::SmoothNormals(std::vector<Footprint>& footprints) const
{
  const double half = 0.5 * this->SmoothingLength;
  std::vector<Vector> smooth;
  for (const Footprint& foot : footprints)
  {
    Vector sum = foot.normal;
    for (const Footprint& other : footprints)
    {
      if (std::abs(other.along - foot.along) <= half)
      {
        sum += other.normal;
      }
    }
    smooth.push_back(sum.normalized());
  }
  for (std::size_t i = 0; i < footprints.size(); ++i)
  {
    footprints[i].normal = smooth[i];
  }
}

void vtkPressPath::WritePath(const std::vector<Footprint>& footprints, vtkPolyData* output) const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  vtkNew<vtkDoubleArray> inward;
  inward->SetName("Inward");
  inward->SetNumberOfComponents(3);
  const auto append = [&](const Footprint& foot, double depth, double at)
  {
    const Vector tip = foot.point - depth * foot.normal;
    const Vector along = -foot.normal;
    points->InsertNextPoint(tip.data());
    inward->InsertNextTuple(along.data());
    time->InsertNextValue(at);
  };
  const double pressTime = (this->Approach + std::abs(this->Depth)) / this->PressSpeed;
  double now = 0.0;
  append(footprints.front(), -this->Approach, now);
  append(footprints.front(), this->Depth, now += pressTime);
  now += RestTime;
  for (const Footprint& foot : footprints)
  {
    append(foot, this->Depth, now + foot.along / this->SlideSpeed);
  }
  now += footprints.back().along / this->SlideSpeed + RestTime;
  append(footprints.back(), this->Depth, now);
  append(footprints.back(), -this->Approach, now + pressTime);

  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    line->InsertCellPoint(i);
  }
  output->SetPoints(points);
  output->SetLines(line);
  output->GetPointData()->AddArray(time);
  output->GetPointData()->AddArray(inward);
}

void vtkPressPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Directions: " << this->Directions.size() << "\n";
  os << indent << "Depth: " << this->Depth << " mm\n";
  os << indent << "Approach: " << this->Approach << " mm\n";
  os << indent << "PressSpeed: " << this->PressSpeed << " mm/s\n";
  os << indent << "SlideSpeed: " << this->SlideSpeed << " mm/s\n";
  os << indent << "SmoothingLength: " << this->SmoothingLength << " mm\n";
}
