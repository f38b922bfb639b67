// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LayerSurface_h
#define palpate_LayerSurface_h

#include "Mechanics/Tools/AxisymmetricTool.h"
#include "Mechanics/Layers/LayerKernel.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Numerics/ChebyshevRule.h"

#include <Eigen/Core>

namespace palpate
{
class LayerContact;

/**
 * The displacement of an elastic layer's surface under one tool at one depth, for display.
 *
 * With y of LayerKernel.h, and its continuation outside the contact
 *   w(x) = (1/πh) ∫_0^a y(t) [M((t+x)/h) + M((t-x)/h)] dt,
 *   q(x) = (1/πh) ∫_0^a y(t) [L((x+t)/h) + L((x-t)/h)] dt,  L odd,
 * the displacement of the surface is
 *   r <= a  u_z = δ - f(r),
 *   r > a   u_z = (2/π) [∫_0^a (δ-g) dx/√(r²-x²) + ∫_a^r w dx/√(r²-x²)],
 *   u_r = -(1-2ν)/(2π(1-ν)E*) F(r)/r - (2/π) ∫_0^{π/2} q(r sin θ) sin θ dθ,
 * where F(r) is the load within the radius r. Unlike on a half-space, the surface bulges if the
 * layer is nearly incompressible: u_z < 0 at some distance. All displacements decay within a few h.
 *
 * The constructor takes about 1 ms per contact, and at() takes about 3 µs per point. Immutable; can
 * be used from any number of threads.
 */
class PALPATE_EXPORT LayerSurface
{
public:
  /// `deflection` must be in the range 0 < deflection <= contact.deepest(); otherwise all
  /// displacements are zero. `contact` and its tool must outlive this object.
  LayerSurface(const LayerContact& contact, double deflection);

  /// Returns the displacement of the point that was at distance r >= 0 from the axis before
  /// contact, mm.
  SurfaceDisplacement at(double r) const;

private:
  double outside(double r) const;
  double loadInside(double r) const;

  const LayerContact& Contact;
  double Deflection;
  double Radius = 0.0;             ///< contact radius a; 0 if there is no contact
  double Reach = 0.0;              ///< radius beyond which all displacements have decayed, mm
  double Integral = 0.0;           ///< ∫_0^a y dt = F/2E*
  LayerKernel::Samples Correction; ///< (δ - g) - y on the nodes of the kernel
  PiecewiseChebyshev Normal;       ///< w(x)
  PiecewiseChebyshev Radial;       ///< q(x)
};
} // namespace palpate

#endif
