// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerContact_h
#define palpate_LayerContact_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/IndentationLaw.h"
#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Layers/ProfileQuadrature.h"

#include <memory>

namespace palpate
{
/**
 * A tool pressed into an elastic layer of thickness h on a rigid base, bonded or slipping.
 *
 * The law is the exact linear solution (LayerKernel.h) for any axisymmetric tool with reduced
 * profile g. With the solution y₁ for a flat punch and the resolvent Γ,
 *   δ(a) = [g(a) - ∫_0^a Γ g dt]/y₁(a),   F = 2E* ∫_0^a y₁ (δ - g) dt,   dF/dδ = 2E* ∫_0^a y₁ dt.
 * E* = E/(1-ν²) with the ν of the kernel. The law is valid for a <= LayerKernel::LargestRatio h; at
 * larger depths the result is NaN. The assumption of small strain requires δ << h, in addition to
 * the limit of the tool (depthAtStrain).
 *
 * Cost: 10 to 30 µs per evaluation for a smooth tool. Immutable; can be used from any number of
 * threads.
 */
class PALPATE_EXPORT LayerContact final : public IndentationLaw
{
public:
  /// `thickness` is > 0, mm. `tool` must outlive the contact.
  LayerContact(
    const AxisymmetricTool& tool, std::shared_ptr<const LayerKernel> kernel, double thickness);

  IndentationPoint evaluate(double deflection, double reducedModulus) const override;
  double contactRadius(double deflection) const;

  /// Returns the depth (mm) at which the contact radius is a. Returns 0 if a is less than the
  /// smallest contact radius, +inf if a is at least the largest contact radius, and NaN if a
  /// exceeds LargestRatio h.
  double depthAtContactRadius(double a) const;

  /// The largest valid δ, mm; +inf if the contact radius of the tool never exceeds LargestRatio h.
  double deepest() const noexcept { return this->Deepest; }

  const AxisymmetricTool& tool() const noexcept { return this->Tool; }
  const LayerKernel& kernel() const noexcept { return *this->Kernel; }
  const ProfileQuadrature& quadrature() const noexcept { return this->Quadrature; }
  double thickness() const noexcept { return this->Thickness; }

private:
  /// The solution for the tool at one contact radius.
  struct Contact
  {
    double depth;   ///< δ(a), mm
    double flat;    ///< ∫_0^a y₁ dt, mm
    double profile; ///< ∫_0^a y₁ g dt, mm²
  };
  Contact contactAt(double a) const;
  double solveRadius(double deflection, Contact& contact) const;

  const AxisymmetricTool& Tool;
  std::shared_ptr<const LayerKernel> Kernel;
  double Thickness;
  ProfileQuadrature Quadrature;
  double SmallestRadius;
  double LargestRadius; ///< contact radius up to which the law is valid
  double LargestDepth;  ///< δ at LargestRadius
  double Deepest;
};
} // namespace palpate

#endif
