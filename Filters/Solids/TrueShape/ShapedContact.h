// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * An axisymmetric, rigid, frictionless tool pressed along the inward normal into a body whose
 * regular Green function is known around the point: one contact radius after the other, without
 * iteration.
 *
 * Dimensionality reduction turns r^{2m} into φ_m(x) = κ_m x^{2m}, κ = 1, 2, 8/3, 16/5, on both
 * sides of the kernel, so that the contact of radius a is y(x) + 2E* Σ c_mn φ_m(x) Y_n = δ - g(x),
 * Y_n = ∫_0^a φ_n y dx,  F = 2E* Y₀,  y(a) = 0 where smooth, the integral equation of a half-space
 * with a kernel of rank N. g is that of the tool plus the angle mean of the surface's drop.
 *
 * What that leaves is added. By its own shape the surface leans by s and waves (SurfaceGap), and
 * next to an edge it turns by βF under the force; to second order U*(F) is less by ½ E* ∫_0^a
 * (|2x(s
 * + βF)|² + Σ g_m²) dx and δ -= ½ E* (4a² |s + βF|² + Σ g_m²) da/dF + β·(s + βF) T,  T = (4/3) E*
 * a³. Where the shape does more than that describes, its part is solved for (UnevenContact).
 *
 * Linear elasticity at small strain; finite strain multiplies what is local of a contact, as it
 * does on a half-space under the same force (StrainCorrection), and what the body gives way
 * otherwise grows with that.
 */
#ifndef palpate_ShapedContact_h
#define palpate_ShapedContact_h

#include "Mechanics/Layers/ProfileQuadrature.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Solids/TrueShape/ContactCurve.h"
#include "Solids/TrueShape/ContactKernels.h"

#include <optional>

namespace palpate
{
class StrainCorrection;

/// One tool, on any number of bodies and points.
class PALPATE_EXPORT ShapedContact
{
public:
  /// `tool` and `strain` must outlive it. `strain`: that of half-spaces; null for small strain.
  /// `samples`: contact radii of a curve.
  explicit ShapedContact(
    const AxisymmetricTool& tool, const StrainCorrection* strain = nullptr, int samples = 24);

  /// The curve at a point. Empty where the site is not valid, or the tool begins wider than
  /// the kernels reach: then end() says why. Safe from any number of threads.
  ContactCurve curve(
    const ContactKernels& kernels, int largestOrder = ContactKernel::LargestOrder) const;

  /// One contact: what a kernel makes of a radius, without the tilt.
  struct Contact
  {
    double deflection = 0.0; ///< mm
    double force = 0.0;      ///< N
    double stiffness = 0.0;  ///< 2E* Y₀ of a unit flat: dF/dδ while the kernel stays; N/mm
    bool stable = false;     ///< the kernel lets δ rise
  };
  /// `deflection` for a contact that has reached the tool's wall, or of a flat: it is given then.
  Contact at(double radius, const ContactKernel& kernel, double reducedModulus,
    std::optional<double> deflection = {}) const;

private:
  struct Course;
  bool takeSample(double radius, std::optional<double> deflection, const ContactKernels& kernels,
    int largestOrder, Course& course) const;

  void addStrain(const ContactKernels& kernels, Course& course) const;

  const AxisymmetricTool& Tool;
  const StrainCorrection* Strain;
  ProfileQuadrature Quadrature;
  int Count;
};
} // namespace palpate

#endif
