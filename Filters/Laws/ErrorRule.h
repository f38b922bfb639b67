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

/// How far a force may be off, as fractions of it, by what is left out or not known.
struct ErrorParts
{
  std::array<double, ResponseLimitCount> of{}; ///< by ResponseLimit; that of None is storage

  double& operator[](ResponseLimit limit) { return of[static_cast<std::size_t>(limit)]; }
  double total() const;
  ResponseLimit largest() const;
};

/// What is known of a spot besides its material.
struct SpotSurface
{
  SpotCurvature curvature; ///< as the mesh has it, whether the law has it or not
  NearEdge edge;
  /// The contact at which the material was measured; null: it was not.
  const LocalState* measured = nullptr;
};

/// What a law takes into account, and what it does not.
struct LawScope
{
  bool curvature = false;                   ///< the sag of the body is in the law
  const StrainCorrection* strain = nullptr; ///< finite strain is in the law
  double bodyWidth = 0.0;                   ///< mm, of the whole body
  double storage = 0.0;                     ///< relative error of stored curves
  const LayerStack* stack = nullptr;        ///< layers on each other, thick as the spot has it
  bool edges = false;                       ///< a tick feels sharp edges (BodyEdges)
};

/**
 * Relative error of a tool's law at a depth, part by part; they are added, since they may agree in
 * sign. With a the contact radius, F the force, κ_m the body's mean curvature and σ its error:
 *
 * - Strain, Thickness: what the small-strain law lacks (smallStrainError), on a layer named after
 *   its larger term; with a StrainCorrection, that one's own error. In a stack 1.6 times
 *   the mean over its layers, each by the part of the depth that is its own and the pressure that
 *   reaches it.
 * - Curvature: left out, |κ_m| times 2/3 E* a³/F, to first order for any tool, in hollows with a
 *   second; in the law, none of that. In both: ln²(B/A)/48 of unequal curvatures, σ times 2/3 E*
 * a³/F, and, unless the body's own compliance is known, q a |κ_m| for what a body yields less as a
 * whole than a half-space: q = 0.46 of a ball, in hollows more with a body that changes its volume,
 * as in a cavity, 0.46 + 1.95 (½-ν) + 0.32 (1-2ν)² ln(1/(a |κ_m|)).
 * - Edge: 1 - Φ(d/a) of the edge that takes most (edgeFactor, edgeSharpness); on a layer times
 *   e^(-d/h), as its base holds it. Not where the body's own compliance is known, which contains
 *   it. At an open border the body is taken to go on unseen: as much as at a right-angled edge,
 * less and less to 2 a away. Of a sharp edge that the tick feels, FeltEdge of that at a right angle
 * and, as edgeSharpness is less certain, FeltWedge at others. All of the force where the contact is
 * wider than the whole body.
 * - Elements: how far the compliance may be off, times dF/dδ.
 * - None: storage.
 *
 * A material that was measured has in it what shape and strain did to the contact it was measured
 * with: of curvature and edge the difference from that contact's counts, of strain, which the rule
 * bounds rather than finds, the larger of the two. What noise and the
 * distance of the sites leave open (DataEnd) is added by whoever knows.
 *
 * In series with a compliance a local error counts by the local part of the series, k/k_local.
 * Sources: finite elements with finite strain, on layers, balls and in cavities; Hertz 1882;
 * Hetényi 1970 (edges). How often it holds: Testing/Cxx/Laws/RandomContactTest.cxx and the study
 * error.
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
