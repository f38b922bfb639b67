// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ErrorRule_h
#define palpate_ErrorRule_h

#include "Contact/ResponseContract.h"
#include "Laws/ContactSpot.h"
#include "Laws/CurvedContact.h"
#include "Laws/EdgeDistance.h"
#include "Mechanics/FiniteStrain/StrainCorrection.h"
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/PalpateExport.h"

#include <array>

namespace palpate
{
class AxisymmetricTool;

/// Relative errors of a force because of neglected or unknown effects.
struct ErrorParts
{
  /// One error per ResponseLimit; the entry None is the storage error.
  std::array<double, ResponseLimitCount> of{};

  double& operator[](ResponseLimit limit) { return of[static_cast<std::size_t>(limit)]; }
  PALPATE_EXPORT double total() const;
  PALPATE_EXPORT double norm() const; ///< root of the sum of squares, for independent error sources
  PALPATE_EXPORT ResponseLimit largest() const;
};

/// The surface at a spot, and the contact with which the material was measured.
struct SpotSurface
{
  SpotCurvature curvature; ///< curvature of the mesh, given even if the law does not include it
  NearEdge edge;
  /// The contact with which the material was measured; null if the material was not measured.
  const LocalState* measured = nullptr;
};

/// The effects that a law includes.
struct LawScope
{
  bool curvature = false;                   ///< the law includes the body's curvature
  const StrainCorrection* strain = nullptr; ///< the law includes finite strain
  double bodyWidth = 0.0;                   ///< mm, width of the whole body
  double storage = 0.0;                     ///< relative error of stored curves
  const LayerStack* stack = nullptr;        ///< a stack of layers, with the spot's thicknesses
  bool edges = false; ///< the servo tick corrects the effect of sharp edges (BodyEdges)
};

/**
 * Relative error of the law of a tool at a depth, as a list of parts. The parts are added, because
 * they may have the same sign. Symbols: contact radius a, force F, mean curvature of the body κ_m,
 * error σ of κ_m.
 *
 * - Strain, Thickness: the error of the assumption of small strain (smallStrainError). On a layer,
 *   it is assigned to the limit with the larger term. With a StrainCorrection it is the error of
 *   that correction. In a stack it is 1.6 times the mean over the layers; the strain of each layer
 *   follows from its fraction of the depth and the pressure on the layer.
 * - Thickness: additionally the change of the force by the errors of the layers' thicknesses
 *   (ResponseLaw::thicknessEffect).
 * - Curvature: if the law does not include the curvature, |κ_m| times 2/3 E* a³/F, to first order
 *   for any tool, and with a second-order term in hollows. If the law includes the curvature, this
 *   term is 0. In both cases ln²(B/A)/48 for unequal curvatures and σ times 2/3 E* a³/F are added.
 *   If the body's own compliance is unknown, q a |κ_m| is added for the global compliance, which is
 *   less than that of a half-space; q = 0.46 for a sphere. In hollows q is larger for a
 *   compressible body, as in a cavity: 0.46 + 1.95 (½-ν) + 0.32 (1-2ν)² ln(1/(a |κ_m|)).
 * - Edge: 1 - Φ(d/a) of the edge with the largest effect (edgeFactor, edgeSharpness). On a layer it
 *   is multiplied by e^(-d/h), because the base supports the layer. It is 0 if the body's own
 *   compliance is known, because this compliance contains the effect. Beyond an open border the
 *   missing part of the body is assumed to exist: the error at the border is that of a right-angled
 *   edge, and decreases to 0 at a distance of 2a. If the servo tick corrects the effect of a sharp
 *   edge, the fraction EdgeRemainder remains at a right angle, and WedgeRemainder at other angles,
 *   for which edgeSharpness is less certain. The error is 100 % of the force if the contact is
 *   wider than the whole body.
 * - Elements: the error of the compliance times dF/dδ.
 * - None: the storage error.
 *
 * The measured values of a material already include the effects of shape and strain in the contact
 * with which they were measured. For curvature and edge, the error is therefore the difference from
 * that contact. For strain, for which the rule is only a bound, it is the larger of the two errors.
 * The caller adds the errors caused by noise and by the distance of the sites (DataEnd).
 *
 * In series with a compliance, a local error is multiplied by the local fraction k/k_local of the
 * series. Sources: finite elements with finite strain, on layers, spheres and in cavities; Hertz
 * 1882; Hetényi 1970 (edges). How often the bound holds is tested in
 * Testing/Cxx/Laws/RandomContactTest.cxx and in the study `error`.
 */
class PALPATE_EXPORT ErrorRule
{
public:
  /// `tool` and the objects that `scope` points to must outlive this object.
  ErrorRule(const AxisymmetricTool& tool, const LawScope& scope);

  /// `state` is the state of the local contact.
  ErrorParts at(const ContactSpot& spot, const SpotSurface& surface, const LocalState& state) const
  {
    return this->at(spot, surface, this->strain(spot), state);
  }
  /// As above, for many depths at one spot. `strain` is the result of strain(spot). `thickness` is
  /// the relative change of the local force by the errors of the thicknesses.
  ErrorParts at(const ContactSpot& spot, const SpotSurface& surface,
    const StrainCorrection::Course& strain, const LocalState& state, double thickness = 0.0) const;
  StrainCorrection::Course strain(const ContactSpot& spot) const;

private:
  double stackPart(const ContactSpot& spot, const LocalState& state) const;
  void addStrain(const ContactSpot& spot, const StrainCorrection::Course& strain,
    const LocalState& state, ErrorParts& parts) const;
  double curvaturePart(
    const ContactSpot& spot, const SpotSurface& surface, const LocalState& state) const;
  double edgePart(const ContactSpot& spot, const NearEdge& edge, const LocalState& state) const;

  const AxisymmetricTool& Tool;
  LawScope Scope;
};
} // namespace palpate

#endif
