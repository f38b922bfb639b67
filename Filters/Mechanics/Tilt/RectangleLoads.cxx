// SPDX-License-Identifier: BSD-3-Clause
#include "Mechanics/Tilt/RectangleLoads.h"

#include "Mechanics/Numerics/Constants.h"

#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
/// Love's displacement is the sum of this term over four corners.
double cornerTerm(double x, double y)
{
  return (x == 0.0 ? 0.0 : x * std::asinh(y / std::abs(x))) +
    (y == 0.0 ? 0.0 : y * std::asinh(x / std::abs(y)));
}
} // namespace

RectangleLoads::RectangleLoads(int n, double width, double height)
  : Count(static_cast<std::size_t>(n))
{
  const std::size_t whole = 2 * this->Count;
  for (std::size_t k = 0; k < this->Count; ++k)
  {
    const double angle = 2.0 * Pi * static_cast<double>(k) / static_cast<double>(whole);
    this->Cosines.push_back(std::cos(angle));
    this->Sines.push_back(std::sin(angle));
  }
  this->Order.assign(whole, 0);
  for (std::size_t bit = 1; bit < whole; bit *= 2)
  {
    for (std::size_t k = 0; k < whole; ++k)
    {
      this->Order[k] |= (k & bit) != 0 ? whole / (2 * bit) : 0;
    }
  }
  const auto room = [whole](Rows& rows, std::size_t wide)
  {
    rows.width = wide;
    rows.real.assign(whole * wide, 0.0);
    rows.imaginary.assign(whole * wide, 0.0);
  };

  // The corners are at half-integer positions, from -1/2 to n + 1/2.
  const std::size_t corners = this->Count + 2;
  std::vector<double> terms(corners * corners);
  for (std::size_t j = 0; j < corners; ++j)
  {
    for (std::size_t i = 0; i < corners; ++i)
    {
      terms[i + corners * j] =
        cornerTerm((static_cast<double>(i) - 0.5) * width, (static_cast<double>(j) - 0.5) * height);
    }
  }
  std::vector<double> field(whole * whole);
  const auto distance = [whole](std::size_t i) { return i <= whole / 2 ? i : whole - i; };
  for (std::size_t j = 0; j < whole; ++j)
  {
    for (std::size_t i = 0; i < whole; ++i)
    {
      const double* corner = terms.data() + distance(i) + corners * distance(j);
      field[i + whole * j] = (corner[1 + corners] - corner[1] - corner[corners] + corner[0]) / Pi;
    }
  }
  room(this->Along, whole / 2);
  room(this->Across, this->Count + 1);
  this->toSpectrum(field, whole);
  const double norm = 1.0 / static_cast<double>(whole * whole);
  this->Kernel = this->Across.real; // the transform of an even field is real
  for (double& value : this->Kernel)
  {
    value *= norm;
  }
  room(this->Along, this->Count / 2);
}

/// Computes the Fourier transform of each column. `Order` maps wave numbers to positions in the
/// result.
void RectangleLoads::transform(Rows& rows) const
{
  const std::size_t whole = 2 * this->Count;
  const std::size_t width = rows.width;
  for (std::size_t length = whole; length >= 2; length /= 2)
  {
    const std::size_t half = length / 2;
    const std::size_t step = whole / length;
    for (std::size_t j = 0; j < half; ++j)
    {
      const double c = this->Cosines[j * step];
      const double s = -this->Sines[j * step];
      for (std::size_t block = j; block < whole; block += length)
      {
        double* ar = rows.real.data() + block * width;
        double* ai = rows.imaginary.data() + block * width;
        double* br = ar + half * width;
        double* bi = ai + half * width;
        for (std::size_t k = 0; k < width; ++k)
        {
          const double re = ar[k] - br[k];
          const double im = ai[k] - bi[k];
          ar[k] += br[k];
          ai[k] += bi[k];
          br[k] = re * c - im * s;
          bi[k] = re * s + im * c;
        }
      }
    }
  }
}

/// Computes the inverse Fourier transform of each column, multiplied by 2n.
void RectangleLoads::transformBack(Rows& rows) const
{
  const std::size_t whole = 2 * this->Count;
  const std::size_t width = rows.width;
  for (std::size_t length = 2; length <= whole; length *= 2)
  {
    const std::size_t half = length / 2;
    const std::size_t step = whole / length;
    for (std::size_t j = 0; j < half; ++j)
    {
      const double c = this->Cosines[j * step];
      const double s = this->Sines[j * step];
      for (std::size_t block = j; block < whole; block += length)
      {
        double* ar = rows.real.data() + block * width;
        double* ai = rows.imaginary.data() + block * width;
        double* br = ar + half * width;
        double* bi = ai + half * width;
        for (std::size_t k = 0; k < width; ++k)
        {
          const double re = br[k] * c - bi[k] * s;
          const double im = br[k] * s + bi[k] * c;
          br[k] = ar[k] - re;
          bi[k] = ai[k] - im;
          ar[k] += re;
          ai[k] += im;
        }
      }
    }
  }
}

/// Computes the Fourier transform of a field of rows x rows numbers. The result is in Across.
void RectangleLoads::toSpectrum(const std::vector<double>& field, std::size_t rows)
{
  const std::size_t whole = 2 * this->Count;
  const std::size_t pairs = rows / 2;
  this->Along.real.assign(whole * pairs, 0.0);
  this->Along.imaginary.assign(whole * pairs, 0.0);
  for (std::size_t pair = 0; pair < pairs; ++pair)
  {
    const double* first = field.data() + 2 * pair * rows;
    for (std::size_t i = 0; i < rows; ++i)
    {
      this->Along.real[i * pairs + pair] = first[i];
      this->Along.imaginary[i * pairs + pair] = first[i + rows];
    }
  }
  this->transform(this->Along);
  // Each complex row contains two real rows. The part that is even under k → -k with conjugation
  // belongs to the first row, the odd part to the second row.
  const std::size_t wide = this->Across.width;
  this->Across.real.assign(whole * wide, 0.0);
  this->Across.imaginary.assign(whole * wide, 0.0);
  for (std::size_t k = 0; k < wide; ++k)
  {
    const std::size_t at = this->Order[k] * pairs;
    const std::size_t mirror = this->Order[(whole - k) % whole] * pairs;
    for (std::size_t pair = 0; pair < pairs; ++pair)
    {
      const double re = this->Along.real[at + pair];
      const double im = this->Along.imaginary[at + pair];
      const double mirrorRe = this->Along.real[mirror + pair];
      const double mirrorIm = this->Along.imaginary[mirror + pair];
      const std::size_t first = 2 * pair * wide + k;
      this->Across.real[first] = 0.5 * (re + mirrorRe);
      this->Across.imaginary[first] = 0.5 * (im - mirrorIm);
      this->Across.real[first + wide] = 0.5 * (im + mirrorIm);
      this->Across.imaginary[first + wide] = 0.5 * (mirrorRe - re);
    }
  }
  this->transform(this->Across);
}

void RectangleLoads::displace(const std::vector<double>& pressures, std::vector<double>& depths)
{
  const std::size_t n = this->Count;
  const std::size_t whole = 2 * n;
  this->toSpectrum(pressures, n);
  for (std::size_t i = 0; i < this->Kernel.size(); ++i)
  {
    this->Across.real[i] *= this->Kernel[i];
    this->Across.imaginary[i] *= this->Kernel[i];
  }
  this->transformBack(this->Across);
  const std::size_t pairs = n / 2;
  const std::size_t wide = this->Across.width;
  for (std::size_t k = 0; k < wide; ++k)
  {
    const std::size_t at = this->Order[k] * pairs;
    const std::size_t mirror = this->Order[(whole - k) % whole] * pairs;
    for (std::size_t pair = 0; pair < pairs; ++pair)
    {
      const std::size_t first = 2 * pair * wide + k;
      const double re = this->Across.real[first];
      const double im = this->Across.imaginary[first];
      const double nextRe = this->Across.real[first + wide];
      const double nextIm = this->Across.imaginary[first + wide];
      this->Along.real[mirror + pair] = re + nextIm;
      this->Along.imaginary[mirror + pair] = nextRe - im;
      this->Along.real[at + pair] = re - nextIm;
      this->Along.imaginary[at + pair] = im + nextRe;
    }
  }
  this->transformBack(this->Along);
  depths.resize(n * n);
  for (std::size_t pair = 0; pair < pairs; ++pair)
  {
    double* first = depths.data() + 2 * pair * n;
    for (std::size_t i = 0; i < n; ++i)
    {
      first[i] = this->Along.real[i * pairs + pair];
      first[i + n] = this->Along.imaginary[i * pairs + pair];
    }
  }
}
} // namespace palpate
