// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_ToolLaw_h
#define palpate_endurance_ToolLaw_h

namespace palpate::endurance
{
/**
 * What a rigid tool feels δ deep in a half-space of reduced modulus E*, written down once more from
 * the closed forms (Sneddon 1965): for every profile dF/dδ = 2 E* a, with
 *
 *   flat of radius R   a = R            F = 2 E* R δ
 *   paraboloid         a = √(R δ)       F = 4/3 E* √R δ^1.5
 *   cone               δ = π a / (2 tan α)   F = 2/π E* tan α δ²
 *   exact sphere       δ = a atanh(a/R) F = E* ((a² + R²) atanh(a/R) - a R)
 *
 * mm, N, MPa; depths δ >= 0. Shares nothing with Filters/Mechanics.
 */
class ToolLaw
{
public:
  enum Shape
  {
    Flat,
    Paraboloid,
    Cone,
    Sphere
  };

  /// `size`: the radius in mm, of a cone the angle α from its axis in degrees.
  ToolLaw(Shape shape, double size);

  Shape shape() const { return this->Kind; }
  double size() const { return this->Size; }
  const char* name() const;

  double contactRadius(double depth) const;
  double force(double depth, double modulus) const;
  double stiffness(double depth, double modulus) const;
  /// ∫₀^δ min(dF/dδ, most), the stiffness being one that does not fall.
  double cappedForce(double depth, double modulus, double most) const;
  /// How far, relative, a response stored in 8 samples may be off: the laws that are powers of the
  /// depth are kept to the rounding of float32; the manual's figure of the exact sphere is 2e-4.
  double storageError() const;

private:
  double depthOf(double contactRadius) const;

  Shape Kind;
  double Size;
  double Tangent; ///< of a cone's angle
};
} // namespace palpate::endurance

#endif
