// SPDX-License-Identifier: BSD-3-Clause
#include "StudyBody.h"

#include "Contact/Reduction/ResponseReduction.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

namespace palpate::testing
{
namespace
{
double meanEdgeOf(const Surface& surface)
{
  double sum = 0.0;
  for (const auto& corners : surface.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto from = static_cast<std::size_t>(corners[k]);
      const auto to = static_cast<std::size_t>(corners[(k + 1) % 3]);
      sum += (surface.points[to] - surface.points[from]).norm();
    }
  }
  return sum / (3.0 * static_cast<double>(surface.triangles.size()));
}

std::vector<float> floats(const std::vector<double>& values)
{
  return { values.begin(), values.end() };
}
} // namespace

struct StudyBody::Store
{
  std::vector<float> range;
  std::vector<float> force;
  std::vector<float> stiffness;
  ResponseArrays arrays;
};

StudyBody::StudyBody(Surface surface, std::vector<Spot> spots)
  : Mesh(std::move(surface))
  , Spots(std::move(spots))
  , MeanEdge(meanEdgeOf(this->Mesh))
  , Valid(this->Mesh.points.size(), 0)
{
  const BodyMesh mesh = this->Mesh.mesh();
  for (std::size_t i = 0; i < this->Mesh.points.size(); ++i)
  {
    const Vector3 normal = mesh.pointNormal(static_cast<std::int32_t>(i));
    for (const double part : normal)
    {
      this->Normals.push_back(static_cast<float>(part));
    }
  }
  SampledCurves none;
  none.samples = 2;
  none.range = 1.0;
  none.force.assign(2 * this->pointCount(), 0.0);
  none.stiffness = none.force;
  const Store store = this->store(none);
  this->Contact =
    std::make_unique<ContactBody>(this->Mesh.points.front().data(), this->pointCount(),
      this->Mesh.triangles.front().data(), this->Mesh.triangles.size(), store.arrays);
}

Spot StudyBody::spotAt(const TriangleCorners& corners, const Vector3& weights) const
{
  Spot sum;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto input = static_cast<std::size_t>(this->packed().inputPoint(corners[k]));
    const double weight = weights[static_cast<Eigen::Index>(k)];
    sum.inverseThickness += weight * this->Spots[input].inverseThickness;
    sum.compliance += weight * this->Spots[input].compliance;
  }
  return sum;
}

StudyBody::Store StudyBody::store(const SampledCurves& curves) const
{
  Store store;
  store.range.assign(this->pointCount(), static_cast<float>(curves.range));
  store.force = floats(curves.force);
  store.stiffness = floats(curves.stiffness);
  store.arrays.points = this->pointCount();
  store.arrays.samples = curves.samples;
  store.arrays.exponent = curves.exponent;
  store.arrays.force = store.force.data();
  store.arrays.stiffness = store.stiffness.data();
  store.arrays.normal = this->Normals.data();
  store.arrays.range = store.range.data();
  store.arrays.status = this->Valid.data();
  return store;
}

std::unique_ptr<ContactBody> StudyBody::respond(
  const SampledCurves& curves, const TiltViews& tilts) const
{
  Store store = this->store(curves);
  store.arrays.tilt = tilts;
  return std::make_unique<ContactBody>(*this->Contact, store.arrays);
}

std::unique_ptr<ContactBody> StudyBody::respondReduced(
  const SampledCurves& curves, double tolerance) const
{
  Store store = this->store(curves);
  ReductionSettings settings;
  settings.tolerance = tolerance;
  const ReducedResponse reduced = reduceResponse(store.arrays, settings);
  if (reduced.laws > 0)
  {
    store.arrays.force = nullptr;
    store.arrays.stiffness = nullptr;
    store.arrays.laws = reduced.laws;
    store.arrays.basis = reduced.basis.data();
    store.arrays.coefficient = reduced.coefficient.data();
  }
  else if (reduced.form == ReducedForm::Samples)
  {
    store.arrays.samples = reduced.samples;
    store.arrays.force = reduced.force.data();
    store.arrays.stiffness = reduced.stiffness.data();
  }
  return std::make_unique<ContactBody>(*this->Contact, store.arrays);
}

Surface flatTop(double half, double edge)
{
  Surface top;
  const auto cells = static_cast<std::int32_t>(std::lround(2.0 * half / edge));
  const std::int32_t side = cells + 1;
  for (std::int32_t j = 0; j < side; ++j)
  {
    for (std::int32_t i = 0; i < side; ++i)
    {
      top.points.emplace_back(i * edge - half, j * edge - half, 0.0);
    }
  }
  for (std::int32_t j = 0; j < cells; ++j)
  {
    for (std::int32_t i = 0; i < cells; ++i)
    {
      const std::int32_t a = j * side + i;
      top.triangles.push_back({ a, a + 1, a + side + 1 });
      top.triangles.push_back({ a, a + side + 1, a + side });
    }
  }
  return top;
}

std::unique_ptr<StudyBody> readStudyBody(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string magic;
  std::size_t points = 0;
  std::size_t triangles = 0;
  stream >> magic >> points >> triangles;
  stream.get();
  constexpr std::size_t most = std::size_t{ 1 } << 28;
  if (!stream || magic != "palpate-study" || points == 0 || points > most || triangles == 0 ||
    triangles > most)
  {
    throw std::runtime_error(file + ": not a body of this study");
  }
  Surface surface;
  surface.points.resize(points);
  surface.triangles.resize(triangles);
  std::vector<double> inverse(points);
  const auto read = [&](void* to, std::size_t bytes)
  { stream.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes)); };
  read(surface.points.front().data(), 3 * points * sizeof(double));
  read(inverse.data(), points * sizeof(double));
  read(surface.triangles.front().data(), 3 * triangles * sizeof(std::int32_t));
  if (!stream)
  {
    throw std::runtime_error(file + ": shorter than its first line says");
  }
  std::vector<Spot> spots;
  spots.reserve(points);
  for (const double value : inverse)
  {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      throw std::runtime_error(file + ": a thickness that is none");
    }
    spots.push_back({ value, 0.0 });
  }
  return std::make_unique<StudyBody>(std::move(surface), std::move(spots));
}
} // namespace palpate::testing
