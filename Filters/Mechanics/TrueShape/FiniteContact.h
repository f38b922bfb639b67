// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_FiniteContact_h
#define palpate_FiniteContact_h

#include "Mechanics/FiniteElements/UnitLoads.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/TrueShape/ToolFacets.h"

#include <vector>

namespace palpate
{
/// A contact at finite strain, at a depth.
struct FiniteForce
{
  double force = 0.0;     ///< along the way in, N; NaN beyond the deepest
  double stiffness = 0.0; ///< N/mm
  double turned = 0.0;    ///< angle by which the place turned with what is around the body, rad
};

/**
 * A tool pressed straight into an elastic body of quadratic tetrahedra at finite strain
 * (Neo-Hooke), without friction: the surface moves aside and turns, and pressures act along the
 * tool's own normal. So it decides what DirectContact leaves open, what walls on several sides do,
 * and what a body does that turns away as it bends.
 *
 * Newton's method on the potential of FinitePart, at depths in between that are solved for once.
 * `rest` as DirectContact has it: what is around the body moves as at small strain. Where that
 * turns the place by θ, its own length changes by θ²/2 that are not; on a bar held at one end the
 * force is then up to 2.5 θ² too large (FiniteContactTest). For tools without a flat end, whose rim
 * would need a mesh of its own. The body does not touch itself.
 *
 * Four facets over the contact's radius: within 1 % of the axisymmetric solver on a layer. Cost:
 * some 25 factorisations of the stiffness. Immutable.
 */
class PALPATE_EXPORT FiniteContact
{
public:
  /// Without a contact.
  FiniteContact() = default;
  /// Down to `deepest` (mm), or as far as an equilibrium is found; none in other cells, of
  /// several materials, or where isFor() the tool is false.
  FiniteContact(const ElasticBody& body, const AxisymmetricTool& tool, const DirectPlace& at,
    double deepest, const UnitMotion* rest = nullptr);

  /// mm; 0: no contact was found.
  double deepest() const { return this->Points.empty() ? 0.0 : this->Points.back().deflection; }

  /// At a deflection > 0, mm: what was solved for is joined smoothly, ln F by cubics of ln δ.
  FiniteForce at(double deflection) const;

  /// Whether a tool can be pressed so: one without a flat end.
  static bool isFor(const AxisymmetricTool& tool) { return !(tool.smallestContactRadius() > 0.0); }

private:
  /// Where it was solved.
  struct Point
  {
    double deflection;
    double force;
    double exponent; ///< d ln F / d ln δ
    double turned;
  };
  void join();

  std::vector<Point> Points;
};
} // namespace palpate

#endif
