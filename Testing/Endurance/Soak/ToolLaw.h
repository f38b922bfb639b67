// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_endurance_ToolLaw_h
#define palpate_endurance_ToolLaw_h

namespace palpate::endurance
{
/**
 * Force on a rigid tool at a deflection δ of a half-space of reduced modulus E*. This is an
 * independent implementation of the closed forms (Sneddon 1965). For every profile dF/dδ = 2 E* a,
 * with
 *
 *   flat of radius R   a = R            F = 2 E* R δ
 *   paraboloid         a = √(R δ)       F = 4/3 E* √R δ^1.5
 *   cone               δ = π a / (2 tan α)   F = 2/π E* tan α δ²
 *   exact sphere       δ = a atanh(a/R) F = E* ((a² + R²) atanh(a/R) - a R)
 *
 * mm, N, MPa; depths δ >= 0. Shares no code with Filters/Mechanics.
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

  /// `size`: the radius in mm; for a cone the angle α from its axis in degrees.
  ToolLaw(Shape shape, double size);

  Shape shape() const { return this->Kind; }
  double size() const { return this->Size; }
  const char* name() const;

  double contactRadius(double depth) const;
  double force(double depth, double modulus) const;
  double stiffness(double depth, double modulus) const;
  /// ∫₀^δ min(dF/dδ, most). The stiffness must not decrease with depth.
  double cappedForce(double depth, double modulus, double most) const;
  /// Relative error of a response stored in 8 samples. For laws that are powers of the depth it is
  /// the rounding error of float32; for the exact sphere it is 2e-4, as stated in the manual.
  double storageError() const;

private:
  double depthOf(double contactRadius) const;

  Shape Kind;
  double Size;
  double Tangent; ///< tan α of a cone
};
} // namespace palpate::endurance

#endif
