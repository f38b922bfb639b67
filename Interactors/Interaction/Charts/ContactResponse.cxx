// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Charts/ContactResponse.h"

#include "Response/BodyConversion.h"
#include "Response/Curves/StoredError.h"
#include "Contact/SmoothTriangle.h"
#include "Contact/TriangleProjection.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace palpate
{
namespace
{
using Corners = std::array<Vector3, 3>;

/// Smallest distance of a point from the plane of its triangle, in edge lengths, at which the point
/// is assumed to be on the smooth surface. The value allows for the single precision of the tick's
/// coordinates.
constexpr double OffPlane = 1e-5;

/// Returns the area coordinates of a point of the patch. They are computed by Gauss-Newton steps
/// that start at `foot`, the area coordinates of the point's projection onto the facet. Returns
/// `foot` if there is no patch.
Vector3 weightsOnPatch(
  const Corners& corners, const Corners& normals, const Vector3& point, const Vector3& foot)
{
  // Enough steps, because the convergence is quadratic and the initial error is a few per cent.
  constexpr int Steps = 5;
  SmoothTriangle patch;
  if (!patch.build(corners, normals))
  {
    return foot;
  }
  Vector3 weights = foot;
  for (int i = 0; i < Steps; ++i)
  {
    const SurfaceJet at = patch.evaluate(weights);
    Eigen::Matrix<double, 3, 2> slopes;
    slopes << at.dv, at.dw;
    const Eigen::Vector2d step =
      (slopes.transpose() * slopes).ldlt().solve(slopes.transpose() * (point - at.point));
    weights += Vector3(-step.sum(), step.x(), step.y());
  }
  weights = weights.cwiseMax(0.0);
  return weights.allFinite() ? Vector3(weights / weights.sum()) : foot;
}

/// Returns the values of three points from an array with `count` values per point. Returns an empty
/// list if `values` is null.
template <class Value>
std::vector<Value> ofCorners(
  const Value* values, const std::array<vtkIdType, 3>& corners, std::size_t count)
{
  std::vector<Value> three(values ? 3 * count : 0);
  for (std::size_t k = 0; values && k < 3; ++k)
  {
    const Value* begin = values + count * static_cast<std::size_t>(corners[k]);
    std::copy_n(begin, count, three.data() + k * count);
  }
  return three;
}
} // namespace

bool ContactTriangle::find(
  vtkPolyData* body, const std::string& name, vtkIdType index, const Vector3& point)
{
  if (index < 0 || index >= body->GetNumberOfPolys())
  {
    return false;
  }
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  body->GetPolys()->GetCellAtId(index, count, ids);
  if (count != 3 ||
    std::any_of(
      ids, ids + 3, [body](vtkIdType id) { return id < 0 || id >= body->GetNumberOfPoints(); }))
  {
    return false;
  }
  std::copy_n(ids, 3, this->corners.begin());
  Corners x;
  Corners normals;
  vtkDataArray* directions = body->GetPointData()->GetArray(
    palpate::arrayName(name, palpate::ResponseArray::Normal).c_str());
  for (std::size_t k = 0; k < 3; ++k)
  {
    body->GetPoint(this->corners[k], x[k].data());
    normals[k].setZero();
    if (directions && directions->GetNumberOfComponents() == 3)
    {
      directions->GetTuple(this->corners[k], normals[k].data());
    }
  }
  const TriangleProjection foot = projectOnTriangle(point, x[0], x[1], x[2]);
  const double off = OffPlane * (x[1] - x[0]).norm();
  this->weights = foot.squaredDistance > off * off ? weightsOnPatch(x, normals, point, foot.weights)
                                                   : foot.weights;
  return this->weights.allFinite();
}

std::unique_ptr<ContactResponse> ContactResponse::read(
  vtkPolyData* body, const std::string& name, const ContactTriangle& triangle, std::string& error)
{
  ResponseArrays all;
  if (!viewResponse(body, name, all, error))
  {
    return nullptr;
  }
  const auto& corners = triangle.corners;
  const auto samples = static_cast<std::size_t>(all.samples);
  const auto force = ofCorners(all.force, corners, samples);
  const auto stiffness = ofCorners(all.stiffness, corners, samples);
  const auto coefficient = ofCorners(all.coefficient, corners, static_cast<std::size_t>(all.laws));
  const auto normal = ofCorners(all.normal, corners, 3);
  const auto range = ofCorners(all.range, corners, 1);
  const auto status = ofCorners(all.status, corners, 1);
  ResponseArrays three = all;
  three.points = 3;
  three.force = force.data();
  three.stiffness = stiffness.data();
  three.coefficient = coefficient.data();
  three.normal = normal.data();
  three.range = range.data();
  three.status = status.data();
  std::unique_ptr<ContactResponse> response(new ContactResponse(three, triangle.weights));
  if (all.tilt.areFelt())
  {
    response->Tilts = TiltTable(all.tilt.terms, all.tilt.drops, all.tilt.nodes);
    const auto laws = static_cast<std::size_t>(all.tilt.terms.laws);
    response->TiltWeights[0] = all.tilt.weight ? 0.0 : 1.0;
    for (std::size_t k = 0; all.tilt.weight && k < 3; ++k)
    {
      const float* weights = all.tilt.weight + laws * static_cast<std::size_t>(corners[k]);
      for (std::size_t law = 0; law < laws; ++law)
      {
        response->TiltWeights[law] +=
          triangle.weights[static_cast<Eigen::Index>(k)] * static_cast<double>(weights[law]);
      }
    }
  }
  auto* errors = vtkFloatArray::SafeDownCast(
    body->GetPointData()->GetArray(arrayName(name, ResponseArray::Error).c_str()));
  if (errors && errors->GetNumberOfTuples() == body->GetNumberOfPoints())
  {
    response->Errors = ofCorners<float>(
      errors->GetPointer(0), corners, static_cast<std::size_t>(errors->GetNumberOfComponents()));
  }
  const float* validity = nullptr;
  const unsigned char* limit = nullptr;
  std::string untold;
  if (viewValidity(body, name, validity, limit, untold))
  {
    for (const vtkIdType corner : corners)
    {
      response->Validity = std::min(response->Validity, static_cast<double>(validity[corner]));
    }
  }
  return response;
}

bool ContactResponse::isSound() const
{
  bool sound = true;
  for (int k = 0; k < 3; ++k)
  {
    sound = sound && (this->Weights[k] == 0.0 || this->Field.isValid(k));
  }
  return sound;
}

double ContactResponse::cornerForce(int k, double deflection) const
{
  return this->Field.isValid(k) ? this->Field.evaluate(k, deflection).force
                                : std::numeric_limits<double>::quiet_NaN();
}

double ContactResponse::force(double deflection) const
{
  return this->isSound() ? this->blend().evaluate(deflection).force
                         : std::numeric_limits<double>::quiet_NaN();
}

double ContactResponse::tiltedForce(double deflection, double angle) const
{
  const double upright = this->force(deflection);
  if (!this->hasTilt() || !(deflection > 0.0))
  {
    return upright;
  }
  const TiltFactor factor = this->Tilts.at(deflection, angle, this->TiltWeights.data());
  return factor.value * upright + factor.byDepth * this->blend().energy(deflection);
}

double ContactResponse::error(double deflection) const
{
  const std::size_t samples = this->Errors.size() / 3;
  double error = samples > 0 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; samples > 0 && k < 3; ++k)
  {
    const double weight = this->Weights[static_cast<Eigen::Index>(k)];
    error += weight == 0.0 ? 0.0
                           : weight *
        errorBetween(this->Errors.data() + k * samples, static_cast<int>(samples),
          this->Field.range(static_cast<std::int32_t>(k)), deflection);
  }
  return error;
}

double ContactResponse::range() const
{
  return this->isSound() ? this->blend().range() : std::numeric_limits<double>::quiet_NaN();
}
} // namespace palpate
