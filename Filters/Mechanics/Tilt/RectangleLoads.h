// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_RectangleLoads_h
#define palpate_RectangleLoads_h

#include <vector>

namespace palpate
{
/**
 * How the surface of a half-space, E* = 1, goes down under pressures that are constant on each of
 * n x n equal rectangles: Love's closed form of one (1929), summed over all by a convolution of
 * twice as many in Fourier space, the rest of them empty.
 *
 * Not for several threads at once: it keeps the room it works in. Cost: 0.2 ms of 64 x 64, of which
 * Eigen's transform, row by row, takes 2.5 times as much; some 10 000 make a tool's table.
 */
class RectangleLoads
{
public:
  /// n a power of two, >= 4; sides of a rectangle, mm.
  RectangleLoads(int n, double width, double height);

  /// Of pressures (MPa) at i + n j the depths (mm) of the centres; i counts along the width.
  void displace(const std::vector<double>& pressures, std::vector<double>& depths);

private:
  /// Complex numbers, `width` in each of 2n rows.
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
  std::vector<double> Cosines; ///< of 2π k/2n
  std::vector<double> Sines;
  std::vector<std::size_t> Order; ///< where transform() leaves number k
  Rows Along;                     ///< along the width, two rows of rectangles as one complex row
  Rows Across;                    ///< across it, of each wave number along it
  std::vector<double> Kernel;
};
} // namespace palpate

#endif
