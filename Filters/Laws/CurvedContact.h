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
/// A tool fits into a hollow if the sum of the curvatures of the tool and the body is at least this
/// fraction of the tool's curvature.
constexpr double LeastSum = 0.5;

/// A contact for E* = 1 on one body, at ascending depths. Values between these depths are
/// interpolated.
struct ContactNodes
{
  std::vector<double> depths;      ///< mm
  std::vector<double> forces;      ///< F/E*, mm²
  std::vector<double> stiffnesses; ///< (dF/dδ)/E*, mm
  std::vector<double> radii;       ///< contact radius, mm
  /// Depth at which the tool has the same contact radius on the flat body, mm.
  std::vector<double> toolDepths;
  bool coversTouch = true; ///< false if no law is valid at depths below that of the first node

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
  /// Depth at which the tool has the same contact radius on the flat body, mm. If negative, it must
  /// be computed from the radius.
  double toolDepth = -1.0;
  double toolTurn = 1.0; ///< derivative of toolDepth with respect to `depth`
  /// False if no law is valid at this depth. The values then only serve to find the smallest depth
  /// with a valid law.
  bool isCovered = true;
};

/**
 * A law that interpolates between nodes with cubic Hermite polynomials of F over √δ. The forces of
 * spheres (F ~ δ^1.5), flat ends (δ) and cones (δ²) are powers of √δ. Below the first node the law
 * is a power of δ through that node. With 64 nodes that are evenly spaced in √δ the error is 1e-6.
 */
class PALPATE_EXPORT NodeLaw final : public IndentationLaw
{
public:
  /// `nodes` must have at least one node. Its depths must be > 0 and ascending.
  explicit NodeLaw(ContactNodes nodes)
    : Nodes(std::move(nodes))
  {
  }

  /// Returns F (N), dF/dδ (N/mm) and the contact radius (mm); 0 for δ <= 0, NaN beyond the last
  /// node.
  IndentationPoint evaluate(double deflection, double reducedModulus) const override;
  LocalState at(double depth) const;
  double deepest() const { return this->Nodes.depths.back(); }

private:
  ContactNodes Nodes;
};

/// The contact of the sag on the same flat body. The sag is a paraboloid of curvature `curvature`
/// (1/mm) that represents the curvature of the body. On a half-space there is a closed form
/// (Hertz): F = 4/3 κ a³ and δ = κ a².
struct SagLaw
{
  double curvature = 1.0;
  ContactNodes nodes; ///< empty for a half-space
};

/**
 * The law of a tool on a curved body. The sag of the body below its tangent plane is added to the
 * tool's profile.
 *
 * At the same contact radius a, the depths and the forces of two profiles can be added, because the
 * contact problem is linear in the profile if its circle is known (Sneddon 1965; this is also true
 * on layers). Therefore the tool's nodes on the flat body, δ(a) and F(a), become δ + κ δ_sag(a) and
 * F + κ F_sag(a). dF/dδ does not change, because it depends only on a.
 *
 * For a flat end of radius b in full contact the law depends only on the mean curvature κ_m:
 *   F = 2E*b(δ - b²κ_m/3),
 * where δ is the deflection of its centre. On a convex body the flat end is in full contact for
 * δ >= κ b²; at smaller depths the law is that of the sag. On a saddle or in a hollow it is in full
 * contact if δ is at least b² times the larger of |κ₁| and |κ₂| (wholeFrom). At smaller depths only
 * parts of its rim touch, and no law is known; a power of the depth is used instead.
 *
 * Two unequal curvatures are represented by the single curvature κ = √((κ_t+κ₁)(κ_t+κ₂)) - κ_t,
 * where κ_t = g(a)/a² for the tool's profile g at the contact radius a. F is multiplied by 1 +
 * ln²((κ_t+κ₂)/(κ_t+κ₁))/48. For a sphere the error is 1e-4 up to a ratio of the two sums of 3
 * (compared with Hertz's ellipse).
 *
 * If the body is concave and the tool does not fit into it (a sum of curvatures is below LeastSum
 * κ_t), no law is valid. The result ends at the depth at which this occurs, and may be empty. In a
 * hollow, the rim of a flat end touches first. The result then begins at the depth at which the
 * flat end is in full contact.
 */
PALPATE_EXPORT ContactNodes onCurvedBody(
  const ContactNodes& flat, const SagLaw& sag, const SpotCurvature& curvature);

/// Returns the smallest depth (mm) at which a flat end of radius `b` is in full contact with a body
/// that is not convex; 0 for a convex body.
PALPATE_EXPORT double wholeFrom(double b, const SpotCurvature& curvature);

/// Returns ln²(B/A)/48, where A and B are the sums of the tool's curvature κ_t (1/mm) and each of
/// the two curvatures of the body; +inf if the tool does not fit.
PALPATE_EXPORT double ellipseFactor(double toolCurvature, const SpotCurvature& curvature);
} // namespace palpate

#endif
