// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_CurvedContact_h
#define palpate_CurvedContact_h

#include "Laws/ContactSpot.h"
#include "Mechanics/IndentationLaw.h"
#include "Mechanics/PalpateExport.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace palpate
{
/// Of the sum of two curvatures, over the tool's, that a tool still fits into a hollow.
constexpr double LeastSum = 0.5;

/// A contact for E* = 1 on one body, at ascending depths: what is between is interpolated.
struct ContactNodes
{
  std::vector<double> depths;      ///< mm
  std::vector<double> forces;      ///< F/E*, mm²
  std::vector<double> stiffnesses; ///< (dF/dδ)/E*, mm
  std::vector<double> radii;       ///< of the contact, mm
  std::vector<double> toolDepths;  ///< of the tool with that radius on the flat body, mm
  bool coversTouch = true;         ///< false: no law holds above the first node

  std::size_t size() const noexcept { return this->depths.size(); }
  void reserve(std::size_t nodes);
  void add(double depth, double force, double stiffness, double radius, double toolDepth);
};

/// A contact at one depth, for E* = 1; NaN beyond the last node.
struct LocalState
{
  double depth = 0.0;     ///< mm
  double force = 0.0;     ///< F/E*, mm²
  double stiffness = 0.0; ///< (dF/dδ)/E*, mm
  double radius = 0.0;    ///< mm
  /// Of the tool with that radius on the flat body, mm; negative: to be found from the radius.
  double toolDepth = -1.0;
  double toolTurn = 1.0; ///< how fast that grows with the depth
  bool isCovered = true; ///< false: the law says nothing there, this only leads to where it does
};

/**
 * Nodes as a law: cubic Hermite polynomials of F over √δ, in which spheres (F ~ δ^1.5), flats (δ)
 * and cones (δ²) are powers; below the first node a power of δ through it. With 64 nodes at even
 * √δ it errs by 1e-6.
 */
class PALPATE_EXPORT NodeLaw final : public IndentationLaw
{
public:
  /// At least one node; depths ascend from above 0.
  explicit NodeLaw(ContactNodes nodes)
    : Nodes(std::move(nodes))
  {
  }

  /// F (N), dF/dδ (N/mm), contact radius (mm); 0 at δ <= 0, NaN beyond the last node.
  IndentationPoint evaluate(double deflection, double reducedModulus) const override;
  LocalState at(double depth) const;
  double deepest() const { return this->Nodes.depths.back(); }

private:
  ContactNodes Nodes;
};

/// The paraboloid of curvature `curvature` (1/mm) on the same body, which stands for the body's
/// sag; on a half-space closed (Hertz), with F = 4/3 κ a³ and δ = κ a².
struct SagLaw
{
  double curvature = 1.0;
  ContactNodes nodes; ///< empty: a half-space
};

/**
 * A tool on a curved body: the body's sag is added to the tool's profile.
 *
 * At one contact radius a the depths and the forces of two profiles add, since the contact problem
 * is linear in the profile once its circle is known (Sneddon 1965; on layers likewise). So the
 * tool's nodes on the flat body, δ(a) and F(a), become δ + κ δ_sag(a) and F + κ F_sag(a), with
 * dF/dδ as it was, which depends on a alone.
 *
 * A flat end of radius b that is touched whole feels the mean curvature alone, whatever the two
 * are: F = 2E*b(δ - b²κ_m/3), δ of its middle. On a convex body it is touched whole from κ b² on,
 * before that the sag is alone; on a saddle or in a hollow from b² times the larger of |κ₁|, |κ₂|
 * (wholeFrom), before that, where its rim bears a part, the force is a power of the depth and no
 * law.
 *
 * Unequal curvatures count by the radius whose square is the product of both sums,
 * κ = √((κ_t+κ₁)(κ_t+κ₂)) - κ_t, κ_t = g(a)/a² of the tool at that circle, and F by
 * 1 + ln²((κ_t+κ₂)/(κ_t+κ₁))/48: 1e-4 to a ratio of 3 for a sphere (Hertz's ellipse).
 *
 * Where the body is hollow and the tool does not fit into it (a sum below LeastSum of κ_t) there is
 * no law: the result then ends, and may be empty. A flat end meets a hollow with its rim: the
 * result begins where it fits.
 */
PALPATE_EXPORT ContactNodes onCurvedBody(
  const ContactNodes& flat, const SagLaw& sag, const SpotCurvature& curvature);

/// Depth (mm) from which a flat end of radius `b` is touched whole by a body that is not convex all
/// round; 0 where it is.
PALPATE_EXPORT double wholeFrom(double b, const SpotCurvature& curvature);

/// ln²(B/A)/48 of a tool of curvature κ_t (1/mm) on the body; +inf where it does not fit.
PALPATE_EXPORT double ellipseFactor(double toolCurvature, const SpotCurvature& curvature);
} // namespace palpate

#endif
