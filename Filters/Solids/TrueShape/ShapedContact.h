// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * An axisymmetric, rigid, frictionless tool pressed along the inward normal into a body with a
 * known regular Green function around the point. The contact radii are solved one after the other,
 * without iteration.
 *
 * Dimensionality reduction replaces r^{2m} by φ_m(x) = κ_m x^{2m}, κ = 1, 2, 8/3, 16/5, in both
 * arguments of the kernel. The contact of radius a then satisfies the integral equation of a
 * half-space with a kernel of rank N:
 *   y(x) + 2E* Σ c_mn φ_m(x) Y_n = δ - g(x),
 *   Y_n = ∫_0^a φ_n y dx,  F = 2E* Y₀,  y(a) = 0 where smooth.
 * g is the reduced profile of the tool plus the mean over angles of the surface's drop.
 *
 * The remaining effects of the shape are added afterwards. The surface has a slope s and waves g_m
 * (SurfaceGap), and next to an edge the force tilts the surface by βF. To second order, the
 * complementary energy U*(F) decreases by
 *   ½ E* ∫_0^a (|2x(s + βF)|² + Σ g_m²) dx
 * and δ decreases by
 *   ½ E* (4a² |s + βF|² + Σ g_m²) da/dF + β·(s + βF) T, T = (4/3) E* a³.
 * If the second order is not sufficient, the uneven contact is solved instead (UnevenContact).
 *
 * The equations are those of linear elasticity at small strain. Finite strain multiplies the local
 * part of a contact, as on a half-space under the same force (StrainCorrection). The remaining
 * deflection of the body grows with the force.
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

/// Contacts of one tool, on any number of bodies and points.
class PALPATE_EXPORT ShapedContact
{
public:
  /// `tool` and `strain` must outlive this object. `strain` is the correction for half-spaces, or
  /// null for small strain. `samples` is the number of contact radii of a curve.
  explicit ShapedContact(
    const AxisymmetricTool& tool, const StrainCorrection* strain = nullptr, int samples = 24);

  /// Returns the curve at a point. The curve is empty if the site is not valid, or if the flat end
  /// of the tool is wider than the largest radius of the kernels. end() of the curve then gives the
  /// reason. Thread-safe.
  ContactCurve curve(
    const ContactKernels& kernels, int largestOrder = ContactKernel::LargestOrder) const;

  /// One contact: the result for one kernel and one radius, without the effect of the tilt.
  struct Contact
  {
    double deflection = 0.0; ///< deflection δ, mm
    double force = 0.0;      ///< force F, N
    /// 2E* Y₀ of a flat end at depth 1, which is dF/dδ for a constant kernel, N/mm
    double stiffness = 0.0;
    bool stable = false; ///< whether δ increases with the radius for this kernel
  };
  /// Computes one contact. `deflection` is given for a flat end, or for a contact at the tool's
  /// wall.
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
