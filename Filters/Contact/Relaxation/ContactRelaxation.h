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
 * What it takes to lead a tool on to material that was not pressed yet (hysteresis friction): a
 * contact that sticks, with the tangential stiffness of the body itself, until the pull is what the
 * new material stores per length.
 *
 * The stiffness changes with the depth: a spring that gets stiffer keeps its force, one that gets
 * softer its displacement, so that no change gives energy (ShapeFriction does the same). What the
 * contact does not slide, it does not exchange: to and fro about one place nothing is new.
 */
class SlidingDrag
{
public:
  void reset() noexcept
  {
    this->Frame.reset();
    this->Displacement.setZero();
  }

  /// Moves to the contact of this tick. Returns the way there, mm; 0 for the first after reset().
  double advance(const Vector3& contactPoint, const Vector3& normal) noexcept
  {
    if (!this->Frame.advance(contactPoint, normal))
    {
      this->Displacement.setZero();
      this->Stiffness = 0.0;
    }
    return this->Frame.step().length();
  }

  /// Along that way. `limit` in N, `stiffness` in N/mm. Returns the length that slid, mm.
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

  /// On the tool, N.
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
 * The stored curve f is the slow response. Elements side by side (RelaxationElements) whose slow
 * force f_N is f by chords carry what memory adds, each letting go by itself; the rest f - f_N
 * relaxes as one quasi-linear branch. F = Σ w_j q_j + (f - f_N) + QLV[f - f_N] is no less than 0,
 * and 0 when the first element lets go. Loading is exact for any number of elements. The contact
 * ends before the tool is out of where it was pressed in, and the dent comes back while nobody
 * touches it. One memory is shared by the three curves of a triangle: q depends on depth and time.
 * Over ramps, holds, releases, triangles, sines and random presses of three materials (P to 4) the
 * largest error, of the largest force, with a sphere and a cone is 0.40 and 0.91 % in 16 elements,
 * 1.3 and 3.0 % in 8, 10 and 12 % quasi-linear (0); with a flat end 0.01 % always.
 *
 * With an elastic compliance C in series, δ = δ_local + C F is solved, and the local part relaxes.
 *
 * Sliding leads the tool on to new material, on which it has pressed but now: the force rises. A
 * share λ = 1 - e^(-s/2a) of the elements is exchanged over a way s (a: contact radius); the energy
 * that takes is the drag's (SlidingDrag). Against a half-space of 3-D cells, sphere and cone: -5.3
 * to 4.7 % of (1 + P) f.
 *
 * Energy: elements and quasi-linear branches of any increasing curve give back no more than was put
 * in, whatever is done. A strength that differs from point to point stores other energy elsewhere:
 * strengthEnergies() is for the force beside.
 *
 * Sources: Lee and Radok 1960; Ting 1966; Fung 1981. Allocates nothing, throws nothing. One object
 * is one history.
 */
class PALPATE_EXPORT ContactRelaxation
{
public:
  /// `body` must outlive it; null: nothing relaxes.
  ContactRelaxation(const BodyRelaxation* body, int elements) noexcept;

  bool isFelt() const noexcept { return this->Body != nullptr; }
  /// Forgets everything: the next contact is taken to have rested where it is found.
  void reset() noexcept;

  /// Adds to the time (s) that the next press() or lift() accounts for; also while the position of
  /// the tip is not known.
  void pass(double elapsed) noexcept { this->Elapsed += elapsed > 0.0 ? elapsed : 0.0; }
  /// A tick without contact.
  void lift() noexcept;
  /// The contact is no longer followed; what the body remembers stays.
  void lose() noexcept
  {
    this->WasTouched = false;
    this->Drag.reset();
  }

  /// A contact in time.
  struct Place
  {
    TriangleCorners corners{};
    Vector3 weights = Vector3::Zero();
    Vector3 point = Vector3::Zero();
    double deflection = 0.0;
  };
  /// What is felt there.
  struct Force
  {
    double total = 0.0;     ///< N
    double stiffness = 0.0; ///< d total/dδ in this tick, N/mm
    bool isTouched = false; ///< else the material has not come back to the tool
  };
  /// `slow` is what the response gives there.
  Force press(const Place& place, const ResponseValue& slow) noexcept;

  /// After a press: leads the tool on along the surface. The force beside, on the tool, N.
  Vector3 slide(const Vector3& contactPoint, const Vector3& normal) noexcept;

  /// Of the force of the last press, what stays under a curve whose stiffness is capped:
  /// `cappedSlow` is that of the slow response, `maximumStiffness` (N/mm) its cap.
  double cappedForce(double cappedSlow, double maximumStiffness) const noexcept;
  /// Of the last press, N.
  double force() const noexcept { return this->Now.total; }
  /// How many times the slow stiffness a loop feels that holds the force from tick to tick.
  double stiffening() const noexcept;

  /// Of the last press, N mm: what memory stores, ...
  double storedEnergy() const noexcept;
  /// ... and how it differs between the corners for their strengths alone.
  Vector3 strengthEnergies() const noexcept;

private:
  void beginTick() noexcept;
  /// To another place, without having been in touch on the way.
  void jumpTo(const Place& place) noexcept;
  void exchange(double share) noexcept;
  void pressElements(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  void pressOne(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  /// The local depth at which the elements, with the compliance in series, are at the tip's.
  double localDepth(const BlendedResponse& curve) const noexcept;
  /// f - f_N of a curve.
  double restAt(const BlendedResponse& curve, double depth) const noexcept
  {
    return curve.evaluate(depth).force - this->Nodes.slowForce(this->Chords, depth);
  }
  /// Of QuasiLinearElement: 1/K, so that squares of forces are energies.
  double secantCompliance() const noexcept;

  const BodyRelaxation* Body;
  ForceNodes Nodes;
  bool IsOne; ///< quasi-linear

  double Elapsed = 0.0;
  double StepTime = -1.0; ///< of Step
  RelaxationStep Step;
  RelaxationElements Elements;
  QuasiLinearElement Rest; ///< of f - f_N
  QuasiLinearElement One;
  double OneDepth = 0.0; ///< at which One was told its force
  double OneSlow = 0.0;  ///< which was this

  Place Last; ///< of the last press
  bool HasBegun = false;
  bool WasTouched = false;
  double Compliance = 0.0; ///< in series, mm/N
  double Depth = 0.0;      ///< local
  double Slow = 0.0;       ///< f there
  double Stiffness = 0.0;  ///< df/dδ there
  double LastRest = 0.0;   ///< f - f_N there
  double RestMemory = 0.0; ///< what memory adds to it
  Force Now;
  ForceNodes::Chords Chords;
  bool HasChords = false; ///< all of them, the same everywhere
  SlidingDrag Drag;
};
} // namespace palpate

#endif
