// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RectangleLoads_h
#define palpate_RectangleLoads_h

#include <vector>

namespace palpate
{
/**
 * Computes the normal displacement of a half-space with E* = 1 under constant pressures on n x n
 * equal rectangles. Love's closed form for one rectangle (1929) is summed by a convolution in
 * Fourier space, zero-padded to twice the size.
 *
 * Not thread-safe, because each object has buffers. Cost: 0.2 ms for 64 x 64. Eigen's Fourier
 * transform, applied row by row, takes 2.5 times as long. The table of a tool needs about 10 000
 * calls.
 */
class RectangleLoads
{
public:
  /// `n` is a power of two, >= 4. `width` and `height` are the sides of one rectangle, mm.
  RectangleLoads(int n, double width, double height);

  /// Computes the depths (mm) of the centres of the rectangles under pressures (MPa). Both arrays
  /// have the index i + n j, where i counts along the width.
  void displace(const std::vector<double>& pressures, std::vector<double>& depths);

private:
  /// Complex numbers: 2n rows of `width` numbers each.
  struct Rows
  {
    std::size_t width = 0;
    std::vector<double> real;
    std::vector<double> imaginary;
  };
  void transform(Rows& rows) const;
  void transformBack(Rows& rows) const;
  void toSpectrum(const std::vector<double>& field, std::size_t rows);

  std::size_t Count;
  std::vector<double> Cosines; ///< cos(2π k/2n)
  std::vector<double> Sines;
  std::vector<std::size_t> Order; ///< position of wave number k in the result of transform()
  Rows Along;  ///< transform along the width; two rows of rectangles form one complex row
  Rows Across; ///< transform across the width, for each wave number along it
  std::vector<double> Kernel;
};
} // namespace palpate

#endif
