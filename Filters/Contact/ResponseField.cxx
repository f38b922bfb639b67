// SPDX-License-Identifier: BSD-3-Clause
#include "ResponseField.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr std::size_t HeadSize = 4;

struct StoredCurve
{
  const float* samples;
  int count;
  double force(int i) const noexcept { return samples[i]; }
  double stiffness(int i) const noexcept { return samples[count + i]; }
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

bool isUsable(std::uint8_t status)
{
  return status == static_cast<std::uint8_t>(ResponseStatus::Valid) ||
    status == static_cast<std::uint8_t>(ResponseStatus::Edge);
}
} // namespace

ResponseField::ResponseField(const ResponseArrays& arrays)
  : Sampling(arrays.samples, arrays.exponent)
  , Points(arrays.points)
  , Laws(arrays.basis ? arrays.laws : 0)
{
  const auto n = static_cast<std::size_t>(arrays.samples);
  const auto laws = static_cast<std::size_t>(this->Laws);
  this->Stride = HeadSize + (laws > 0 ? laws : 2 * n);
  this->Records.resize(this->Stride * this->Points);
  if (laws > 0)
  {
    this->Basis.assign(arrays.basis, arrays.basis + laws * 2 * n);
  }
  for (std::size_t i = 0; i < this->Points; ++i)
  {
    float* record = this->Records.data() + this->Stride * i;
    *record++ = isUsable(arrays.status[i]) ? arrays.range[i] : 0.0F;
    record = std::copy_n(arrays.normal + 3 * i, 3, record);
    if (laws > 0)
    {
      std::copy_n(arrays.coefficient + laws * i, laws, record);
    }
    else
    {
      record = std::copy_n(arrays.force + n * i, n, record);
      std::copy_n(arrays.stiffness + n * i, n, record);
    }
  }
}

Vector3 ResponseField::normal(std::int32_t point) const noexcept
{
  const float* head = this->record(point);
  return { head[1], head[2], head[3] };
}

ResponseValue ResponseField::evaluate(std::int32_t point, double deflection) const noexcept
{
  const float* record = this->record(point);
  const double range = record[0];
  const float* body = record + HeadSize;
  const int n = this->Sampling.samples();
  if (this->Laws > 0)
  {
    return this->Sampling.evaluate(
      CombinedCurve{ body, this->Basis.data(), this->Laws, n }, range, deflection);
  }
  return this->Sampling.evaluate(StoredCurve{ body, n }, range, deflection);
}
} // namespace palpate
