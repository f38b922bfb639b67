// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ErrorRule_h
#define palpate_ErrorRule_h

#include "Contact/ResponseContract.h"
#include "Laws/ContactSpot.h"
#include "Laws/CurvedContact.h"
#include "Laws/EdgeDistance.h"
#include "Mechanics/Layers/LayerStack.h"
#include "Mechanics/PalpateExport.h"

#include <array>

namespace palpate
{
class AxisymmetricTool;
class StrainCorrection;

/// Relative errors of a force by what is neglected or unknown.
struct ErrorParts
{
  std::array<double, ResponseLimitCount> of{}; ///< by ResponseLimit; that of None is storage

  double& operator[](ResponseLimit limit) { return of[static_cast<std::size_t>(limit)]; }
  PALPATE_EXPORT double total() const;
  PALPATE_EXPORT double norm() const; ///< of sources that know nothing of each other
  PALPATE_EXPORT ResponseLimit largest() const;
};

/// The surface at a spot, and its measurement.
struct SpotSurface
{
  SpotCurvature curvature; ///< of the mesh, whether or not the law includes it
  NearEdge edge;
  /// The contact with which the material was measured; null: it was not.
  const LocalState* measured = nullptr;
};

/// What a law takes into account, and what it does not.
struct LawScope
{
  bool curvature = false;                   ///< the law includes the body's curvature
  const StrainCorrection* strain = nullptr; ///< the law includes finite strain
  double bodyWidth = 0.0;                   ///< mm, of the whole body
  double storage = 0.0;                     ///< relative error of stored curves
  const LayerStack* stack = nullptr;        ///< a stack of layers, with the spot's thicknesses
  bool edges = false; ///< the servo tick takes sharp edges into account (BodyEdges)
};

/**
 * Relative error of a tool's law at a depth, part by part; the parts are added, since they may have
 * the same sign. With a the contact radius, F the force, κ_m the body's mean curvature and σ its
 * error:
 *
 * - Strain, Thickness: the error of small strain (smallStrainError), on a layer named after its
 *   larger term; with a StrainCorrection, that one's own error. In a stack 1.6 times the mean over
 *   its layers, each with its own part of the depth and the pressure that reaches it.
 * - Curvature: left out, |κ_m| times 2/3 E* a³/F, to first order for any tool, in hollows with a
 *   second; in the law, none of that. In both: ln²(B/A)/48 of unequal curvatures, σ times 2/3 E*
 *   a³/F, and, unless the body's own compliance is known, q a |κ_m| for the global compliance,
 *   which is less than that of a half-space: q = 0.46 of a ball, in hollows more for a compressible
 *   body, as in a cavity, 0.46 + 1.95 (½-ν) + 0.32 (1-2ν)² ln(1/(a |κ_m|)).
 * - Edge: 1 - Φ(d/a) of the edge with the largest effect (edgeFactor, edgeSharpness); on a layer
 *   times e^(-d/h), as its base holds it. Not where the body's own compliance is known, which
 *   contains it. Beyond an open border the unseen body is assumed to continue: the error is that of
 *   a right-angled edge, falling to 0 at a distance of 2 a. Of a sharp edge that the servo tick
 *   takes into account, the fraction FeltEdge remains at a right angle and, as edgeSharpness is
 *   less certain, FeltWedge at others. All of the force where the contact is wider than the whole
 *   body.
 * - Elements: the error of the compliance times dF/dδ.
 * - None: storage.
 *
 * A measured material includes the effects of shape and strain on the contact it was measured with:
 * of curvature and edge the difference from that contact's counts; of strain, which the rule only
 * bounds, the larger of the two. The error by noise and the distance of the sites (DataEnd) is
 * added by the caller.
 *
 * In series with a compliance a local error counts by the local fraction of the series, k/k_local.
 * Sources: finite elements with finite strain, on layers, balls and in cavities; Hertz 1882;
 * Hetényi 1970 (edges). How often the bound holds: Testing/Cxx/Laws/RandomContactTest.cxx and the
 * study error.
 */
class PALPATE_EXPORT ErrorRule
{
public:
  /// `tool` and what `scope` points to must outlive this.
  ErrorRule(const AxisymmetricTool& tool, const LawScope& scope);

  /// `state` is the local contact.
  ErrorParts at(const ContactSpot& spot, const SpotSurface& surface, const LocalState& state) const;

private:
  double stackPart(const ContactSpot& spot, const LocalState& state) const;
  void addStrain(const ContactSpot& spot, const LocalState& state, ErrorParts& parts) const;
  double curvaturePart(
    const ContactSpot& spot, const SpotSurface& surface, const LocalState& state) const;
  double edgePart(const ContactSpot& spot, const NearEdge& edge, const LocalState& state) const;

  const AxisymmetricTool& Tool;
  LawScope Scope;
};
} // namespace palpate

#endif
