// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ContactRelaxation_h
#define palpate_ContactRelaxation_h

#include "Contact/FrictionFrame.h"
#include "Contact/Relaxation/BodyRelaxation.h"
#include "Contact/Relaxation/ForceNodes.h"
#include "Mechanics/PalpateExport.h"
#include "Mechanics/Relaxation/QuasiLinearElement.h"
#include "Mechanics/Relaxation/RelaxationElements.h"

namespace palpate
{
/**
 * The force needed to move a tool on to material that has not been pressed yet (hysteresis
 * friction). The contact sticks with the tangential stiffness of the body until the tangential
 * force reaches the energy that new material stores per length.
 *
 * The stiffness changes with the depth. When the spring gets stiffer, its force is kept; when it
 * gets softer, its displacement is kept. So no change creates energy (as in ShapeFriction). Only
 * the sliding part of the motion exchanges material: moving back and forth about one place brings
 * nothing new.
 */
class SlidingDrag
{
public:
  void reset() noexcept
  {
    this->Frame.reset();
    this->Displacement.setZero();
  }

  /// Moves to the contact of this tick. Returns the length of the path, mm; 0 for the first after
  /// reset().
  double advance(const Vector3& contactPoint, const Vector3& normal) noexcept
  {
    if (!this->Frame.advance(contactPoint, normal))
    {
      this->Displacement.setZero();
      this->Stiffness = 0.0;
    }
    return this->Frame.step().length();
  }

  /// Slides along the path of advance(). `limit` in N, `stiffness` in N/mm. Returns the length that
  /// slid, mm.
  double slide(double limit, double stiffness) noexcept
  {
    if (stiffness > this->Stiffness)
    {
      this->Displacement *= this->Stiffness / stiffness;
    }
    this->Stiffness = stiffness;
    const StraightStep& step = this->Frame.step();
    const double longest = stiffness > 0.0 ? limit / stiffness : 0.0;
    if (!(longest > Shortest))
    {
      this->Displacement.setZero();
      return step.length();
    }
    StraightStep::clip(this->Displacement, longest);
    Vector2 z = step.toPath(this->Displacement);
    const double slid = StraightStep::moveFreely(z, longest, step.length());
    if (slid > 0.0)
    {
      StraightStep::drag(z, longest, slid);
    }
    this->Displacement = step.fromPath(z);
    return slid;
  }

  /// Force on the tool, N.
  Vector3 force() const noexcept
  {
    return -this->Stiffness * this->Frame.toSpace(this->Displacement);
  }

private:
  static constexpr double Shortest = 1e-12; ///< mm

  FrictionFrame Frame;
  Vector2 Displacement = Vector2::Zero(); ///< elastic
  double Stiffness = 0.0;
};

/**
 * The force of one contact on a body that relaxes, tick by tick.
 *
 * The stored curve f is the slow response. Parallel elements (RelaxationElements) carry the force
 * of memory; each separates from the tool on its own. Their slow force f_N is f approximated by
 * chords. The rest f - f_N relaxes as one quasi-linear branch (QLV). The force F = Σ w_j q_j +
 * (f - f_N) + QLV[f - f_N] is at least 0, and 0 when the first element separates. Loading is exact
 * for any number of elements. On release the contact ends before the tool has left the dent, and
 * the dent then recovers without contact. The three curves of a triangle share one memory, because
 * q depends on depth and time only. Largest errors over ramps, holds, releases, triangles, sines
 * and random presses of three materials (P to 4), as a part of the largest force, for a sphere and
 * a cone: 0.40 and 0.91 % with 16 elements, 1.3 and 3.0 % with 8, 10 and 12 % quasi-linear (no
 * elements). With a flat end the error is 0.01 % in all cases.
 *
 * With an elastic compliance C in series, δ = δ_local + C F is solved, and the local part relaxes.
 *
 * Sliding moves the tool on to new material, which counts as pressed just now: the force rises.
 * Over a path of length s a share λ = 1 - e^(-s/2a) of the elements is exchanged (a: contact
 * radius). The energy for this comes from the drag (SlidingDrag). Error against a half-space of 3-D
 * cells, for sphere and cone: -5.3 to 4.7 % of (1 + P) f.
 *
 * Energy: for any increasing curve and any motion, elements and quasi-linear branches return no
 * more energy than was put in. If the strength differs from point to point, the stored energy
 * differs between places: strengthEnergies() gives the data for the resulting sideways force.
 *
 * Sources: Lee and Radok 1960; Ting 1966; Fung 1981. Allocates nothing, throws nothing. One object
 * is one history.
 */
class PALPATE_EXPORT ContactRelaxation
{
public:
  /// `body` must outlive this object; null: nothing relaxes. `elements` 0 or less: quasi-linear.
  ContactRelaxation(const BodyRelaxation* body, int elements) noexcept;

  bool isFelt() const noexcept { return this->Body != nullptr; }
  /// Forgets everything: the next contact is taken to be at rest in the place where it is found.
  void reset() noexcept;

  /// Adds to the time (s) for which the next press() or lift() accounts, also while the position of
  /// the tip is unknown.
  void pass(double elapsed) noexcept { this->Elapsed += elapsed > 0.0 ? elapsed : 0.0; }
  /// A tick without contact.
  void lift() noexcept;
  /// The contact is no longer followed; the memory of the body stays.
  void lose() noexcept
  {
    this->WasTouched = false;
    this->Drag.reset();
  }

  /// A contact: its triangle, place and deflection.
  struct Place
  {
    TriangleCorners corners{};
    Vector3 weights = Vector3::Zero();
    Vector3 point = Vector3::Zero();
    double deflection = 0.0;
  };
  /// Result of a press.
  struct Force
  {
    double total = 0.0;     ///< N
    double stiffness = 0.0; ///< d total/dδ in this tick, N/mm
    bool isTouched = false; ///< false: the material has not come back to the tool
  };
  /// `slow` is the value of the response at that deflection.
  Force press(const Place& place, const ResponseValue& slow) noexcept;

  /// After a press: moves the tool on along the surface. Returns the sideways force on the tool, N.
  Vector3 slide(const Vector3& contactPoint, const Vector3& normal) noexcept;

  /// The part of the force of the last press that remains under a curve whose stiffness is capped.
  /// `cappedSlow` (N) is the capped slow force, `maximumStiffness` (N/mm) the cap.
  double cappedForce(double cappedSlow, double maximumStiffness) const noexcept;
  /// Force of the last press, N.
  double force() const noexcept { return this->Now.total; }
  /// Stiffness of the contact over the slow stiffness, for a loop that holds the force from tick to
  /// tick.
  double stiffening() const noexcept;

  /// Energy stored by memory in the last press, N mm.
  double storedEnergy() const noexcept;
  /// The energy that memory would store with the strengths of each corner, N mm.
  Vector3 strengthEnergies() const noexcept;

private:
  void beginTick() noexcept;
  /// Continues at another place; the tool was not in contact on the way.
  void jumpTo(const Place& place) noexcept;
  void exchange(double share) noexcept;
  void pressElements(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  void pressOne(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  /// The local depth for which depth + C F is the depth of the tip.
  double localDepth(const BlendedResponse& curve) const noexcept;
  /// f - f_N of a curve.
  double restAt(const BlendedResponse& curve, double depth) const noexcept
  {
    return curve.evaluate(depth).force - this->Nodes.slowForce(this->Chords, depth);
  }
  /// 1/K for the QuasiLinearElement, so that squares of forces become energies.
  double secantCompliance() const noexcept;

  const BodyRelaxation* Body;
  ForceNodes Nodes;
  bool IsOne; ///< quasi-linear

  double Elapsed = 0.0;
  double StepTime = -1.0; ///< time step of Step, s
  RelaxationStep Step;
  RelaxationElements Elements;
  QuasiLinearElement Rest; ///< of f - f_N
  QuasiLinearElement One;
  double OneDepth = 0.0; ///< depth of the last press of One
  double OneSlow = 0.0;  ///< slow force there

  Place Last; ///< of the last press
  bool HasBegun = false;
  bool WasTouched = false;
  double Compliance = 0.0; ///< in series, mm/N
  double Depth = 0.0;      ///< local
  double Slow = 0.0;       ///< f there
  double Stiffness = 0.0;  ///< df/dδ there
  double LastRest = 0.0;   ///< f - f_N there
  double RestMemory = 0.0; ///< force of memory on f - f_N
  Force Now;
  ForceNodes::Chords Chords;
  bool HasChords = false; ///< all chords are known, the same everywhere
  SlidingDrag Drag;
};
} // namespace palpate

#endif
