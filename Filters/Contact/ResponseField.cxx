// SPDX-License-Identifier: BSD-3-Clause
#include "Contact/ResponseField.h"

#include "Contact/ParallelRanges.h"
#include "Contact/RisingStiffness.h"

#include <algorithm>
#include <atomic>

namespace palpate
{
namespace
{
struct StoredCurve
{
  const float* samples;
  double force(int i) const noexcept { return samples[2 * i]; }
  double stiffness(int i) const noexcept { return samples[2 * i + 1]; }
};

struct CombinedCurve
{
  const float* coefficients;
  const float* basis;
  int laws;
  int count;
  double force(int i) const noexcept { return this->combine(i); }
  double stiffness(int i) const noexcept { return this->combine(count + i); }
  double combine(int column) const noexcept
  {
    double sum = 0.0;
    for (int k = 0; k < laws; ++k)
    {
      sum +=
        static_cast<double>(coefficients[k]) * static_cast<double>(basis[k * 2 * count + column]);
    }
    return sum;
  }
};
} // namespace

ResponseField::ResponseField(const ResponseArrays& arrays, const PackedMesh* mesh)
  : Sampling(arrays.samples, arrays.exponent)
  , Points(mesh ? mesh->pointCount() : arrays.points)
  , Laws(arrays.basis ? arrays.laws : 0)
  , Stride(HeadSize + static_cast<std::size_t>(this->Laws > 0 ? this->Laws : 2 * arrays.samples))
  , Energy(this->Sampling)
{
  if (this->Laws > 0)
  {
    this->Basis.assign(arrays.basis,
      arrays.basis +
        static_cast<std::size_t>(this->Laws) * 2 * static_cast<std::size_t>(arrays.samples));
    this->shareCoefficient(arrays);
  }
  this->Records.resize(this->Stride * this->Points);
  const RisingStiffness rising(this->Sampling);
  std::atomic<bool> areAllRising{ !arrays.multipleOf || arrays.multipleOf->hasRisingStiffness() };
  forRanges(this->Points,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t i = first; i < last; ++i)
      {
        const auto point = static_cast<std::int32_t>(i);
        this->pack(arrays, mesh ? static_cast<std::size_t>(mesh->inputPoint(point)) : i, i);
        if (mesh && mesh->isOnCrease(point))
        {
          Eigen::Map<Eigen::Vector3f>(this->Records.data() + this->Stride * i + 1) =
            mesh->pointNormal(point).cast<float>();
        }
      }
      if (!arrays.multipleOf && !this->areRising(rising, first, last))
      {
        areAllRising.store(false, std::memory_order_relaxed);
      }
    });
  this->IsRising = areAllRising.load(std::memory_order_relaxed);
}

void ResponseField::shareCoefficient(const ResponseArrays& arrays)
{
  if (this->Laws != 1)
  {
    return;
  }
  bool found = false;
  for (std::size_t i = 0; i < arrays.points; ++i)
  {
    if (arrays.isUsable(i))
    {
      if (found && arrays.coefficient[i] != this->Shared)
      {
        return;
      }
      this->Shared = arrays.coefficient[i];
      found = true;
    }
  }
  this->Stride = HeadSize;
}

void ResponseField::pack(const ResponseArrays& arrays, std::size_t input, std::size_t point)
{
  const auto n = static_cast<std::size_t>(arrays.samples);
  const auto laws = static_cast<std::size_t>(this->Laws);
  float* record = this->Records.data() + this->Stride * point;
  *record++ = arrays.isUsable(input) ? arrays.range[input] : 0.0F;
  record = std::copy_n(arrays.normal + 3 * input, 3, record);
  if (laws > 0)
  {
    std::copy_n(arrays.coefficient + laws * input, this->Stride - HeadSize, record);
    return;
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    *record++ = arrays.force[n * input + k];
    *record++ = arrays.stiffness[n * input + k];
  }
}

template <class Use>
auto ResponseField::withCurve(std::int32_t point, const Use& use) const noexcept
{
  const float* samples = this->Stride > HeadSize ? this->record(point) + HeadSize : &this->Shared;
  return this->Laws > 0
    ? use(CombinedCurve{ samples, this->Basis.data(), this->Laws, this->Sampling.samples() })
    : use(StoredCurve{ samples });
}

Eigen::Vector4d ResponseField::combineLaws(
  const TriangleCorners& points, const Vector3& weights, int lower) const noexcept
{
  const auto n = static_cast<std::size_t>(this->Sampling.samples());
  const bool isShared = this->Stride == HeadSize;
  const float* law = this->Basis.data() + lower;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < static_cast<std::size_t>(this->Laws); ++k, law += 2 * n)
  {
    double coefficient = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      coefficient += weights[static_cast<Eigen::Index>(i)] *
        static_cast<double>(isShared ? this->Shared : this->record(points[i])[HeadSize + k]);
    }
    sum += coefficient * Eigen::Vector4d(law[0], law[n], law[1], law[n + 1]);
  }
  return sum;
}

bool ResponseField::areRising(
  const RisingStiffness& rising, std::size_t first, std::size_t last) const noexcept
{
  bool areAll = true;
  for (std::size_t i = first; i < last && areAll; ++i)
  {
    const auto point = static_cast<std::int32_t>(i);
    const bool isKnown =
      !this->isValid(point) || (i > first && this->haveSameCurve(point, point - 1));
    areAll = isKnown ||
      this->withCurve(
        point, [&](const auto& curve) { return rising.isOf(curve, this->range(point)); });
  }
  return areAll;
}

ResponseValue ResponseField::evaluate(std::int32_t point, double deflection) const noexcept
{
  return this->withCurve(point,
    [&](const auto& curve)
    { return this->Sampling.evaluate(curve, this->range(point), deflection); });
}

ResponseValue ResponseField::evaluate(
  std::int32_t point, const ResponseSampling::Place& at) const noexcept
{
  return this->withCurve(
    point, [&](const auto& curve) { return this->Sampling.evaluate(curve, at); });
}

double ResponseField::energy(std::int32_t point, double deflection) const noexcept
{
  if (!this->isValid(point))
  {
    return 0.0;
  }
  return this->withCurve(point,
    [&](const auto& curve) { return this->Energy.energy(curve, this->range(point), deflection); });
}

bool ResponseField::haveSameCurve(std::int32_t point, std::int32_t other) const noexcept
{
  const float* a = this->record(point);
  const float* b = this->record(other);
  return a[0] == b[0] && std::equal(a + HeadSize, a + this->Stride, b + HeadSize);
}

double BlendedResponse::range() const noexcept
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    sum += this->Weights[static_cast<Eigen::Index>(k)] * this->Field.range(this->Points[k]);
  }
  return sum;
}

std::array<ResponseValue, 3> BlendedResponse::evaluateEach(double deflection) const noexcept
{
  std::array<ResponseValue, 3> values;
  ResponseSampling::Place at; // its range 0 differs from that of any curve
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (this->Weights[static_cast<Eigen::Index>(k)] == 0.0)
    {
      continue;
    }
    const double range = this->Field.range(this->Points[k]);
    if (range != at.range)
    {
      at = this->Field.sampling().place(range, deflection);
    }
    values[k] = this->Field.evaluate(this->Points[k], at);
  }
  return values;
}

Vector3 BlendedResponse::energies(double deflection) const noexcept
{
  const TriangleCorners& p = this->Points;
  if (this->areAlike())
  {
    return Vector3::Zero();
  }
  // A corner of weight 0 is included, because its weight is about to change.
  Vector3 energies(this->Field.energy(p[0], deflection), this->Field.energy(p[1], deflection),
    this->Field.energy(p[2], deflection));
  const double blend = this->Weights.dot(energies);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (!this->Field.isValid(p[k]))
    {
      energies[static_cast<Eigen::Index>(k)] = blend;
    }
  }
  return energies;
}

double BlendedResponse::energy(double deflection) const noexcept
{
  if (this->areAlike() && this->Field.isValid(this->Points[0]))
  {
    return this->Field.energy(this->Points[0], deflection);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double weight = this->Weights[static_cast<Eigen::Index>(k)];
    sum += weight == 0.0 ? 0.0 : weight * this->Field.energy(this->Points[k], deflection);
  }
  return sum;
}

ResponseValue BlendedResponse::evaluateApart(double deflection) const noexcept
{
  ResponseValue sum;
  const std::array<ResponseValue, 3> values = this->evaluateEach(deflection);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double weight = this->Weights[static_cast<Eigen::Index>(k)];
    sum.force += weight * values[k].force;
    sum.stiffness += weight * values[k].stiffness;
    sum.beyondRange = sum.beyondRange || values[k].beyondRange;
  }
  return sum;
}
} // namespace palpate
