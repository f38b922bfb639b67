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
 * The force needed to move a tool to material that has not been pressed yet (hysteresis friction).
 * The contact sticks with the tangential stiffness of the body until the tangential force reaches
 * the energy that new material stores per unit length.
 *
 * The stiffness changes with the depth. When the spring gets stiffer, its force is kept; when it
 * gets softer, its displacement is kept. Therefore no change creates energy (as in ShapeFriction).
 * Only the sliding part of the motion exchanges material: a small motion back and forth reaches no
 * new material.
 */
class SlidingDrag
{
public:
  void reset() noexcept
  {
    this->Frame.reset();
    this->Displacement.setZero();
  }

  /// Moves to the contact of this tick. Returns the length of the path, mm; 0 for the first contact
  /// after reset().
  double advance(const Vector3& contactPoint, const Vector3& normal) noexcept
  {
    if (!this->Frame.advance(contactPoint, normal))
    {
      this->Displacement.setZero();
      this->Stiffness = 0.0;
    }
    return this->Frame.step().length();
  }

  /// Slides along the path of advance(). `limit` in N, `stiffness` in N/mm. Returns the length of
  /// the sliding part, mm.
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
  Vector2 Displacement = Vector2::Zero(); ///< elastic part, mm
  double Stiffness = 0.0;
};

/**
 * The force of one contact on a body that relaxes, computed tick by tick.
 *
 * The stored curve f is the slow response. Parallel elements (RelaxationElements) carry the memory
 * force; each separates from the tool independently. Their slow force f_N is f approximated by
 * chords. The rest f - f_N relaxes as one quasi-linear branch (QLV). The force F = Σ w_j q_j + (f -
 * f_N) + QLV[f - f_N] is at least 0, and 0 when the first element separates. Loading is exact for
 * any number of elements. On release the contact ends before the tool has left the dent, and the
 * dent then recovers without contact. The three curves of a triangle share one memory, because q
 * depends on depth and time only. The following errors are the largest over ramps, holds, releases,
 * triangles, sines and random presses of three materials (P to 4), as a fraction of the largest
 * force, for a sphere and a cone: 0.40 and 0.91 % with 16 elements, 1.3 and 3.0 % with 8, 10 and 12
 * % with the quasi-linear law (no elements). For a flat end the error is 0.01 % in all cases.
 *
 * With an elastic compliance C in series, δ = δ_local + C F is solved, and the local part relaxes.
 *
 * Sliding moves the tool to new material, which counts as newly pressed: the force rises. Over a
 * path of length s a fraction λ = 1 - e^(-s/2a) of the elements is exchanged (a: contact radius).
 * The work of the drag supplies the energy for this (SlidingDrag). Error compared with a half-space
 * of 3-D cells, for sphere and cone: -5.3 to 4.7 % of (1 + P) f.
 *
 * Energy: for any increasing curve and any motion, elements and quasi-linear branches return no
 * more energy than was put in. If the strength differs from point to point, so does the stored
 * energy; strengthEnergies() returns the data for the resulting sideways force.
 *
 * Sources: Lee and Radok 1960; Ting 1966; Fung 1981. No function allocates or throws. One object is
 * one history.
 */
class PALPATE_EXPORT ContactRelaxation
{
public:
  /// `body` must outlive this object; null: the body does not relax. `elements` <= 0: quasi-linear.
  ContactRelaxation(const BodyRelaxation* body, int elements) noexcept;

  /// Selects whether the next tick adds memory, if the body relaxes. Without memory lift() and
  /// slide() have no effect.
  void setInTime(bool is) noexcept { this->IsInTime = is && this->Body; }
  bool isInTime() const noexcept { return this->IsInTime; }
  /// Resets the memory: the next contact is assumed to have been at rest at the point where it is
  /// found.
  void reset() noexcept;

  /// Adds to the time (s) that the next press() or lift() takes into account, also while the
  /// position of the tip is unknown.
  void pass(double elapsed) noexcept { this->Elapsed += elapsed > 0.0 ? elapsed : 0.0; }
  /// Performs a tick without contact.
  void lift() noexcept;
  /// Ends the contact, but keeps the memory of the body.
  void lose() noexcept
  {
    this->WasTouched = false;
    this->Drag.reset();
  }

  /// A contact: its triangle, area coordinates and deflection.
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
    bool isTouched = false; ///< false: the material is still dented below the tool
  };
  /// Performs a tick in contact; `slow` is the value of the response at the deflection of `place`.
  Force press(const Place& place, const ResponseValue& slow) noexcept;

  /// Moves the tool along the surface; to be called after press(). Returns the sideways force on
  /// the tool, N.
  Vector3 slide(const Vector3& contactPoint, const Vector3& normal) noexcept
  {
    return this->IsInTime ? this->drag(contactPoint, normal) : Vector3(Vector3::Zero());
  }

  /// The fraction (0 to 1) of the force at `depth` on the curve, with the memory of the last press
  /// if there is any, that remains if the stiffness is limited to `maximumStiffness`, N/mm.
  double cappedShare(
    const BlendedResponse& curve, double depth, double maximumStiffness) const noexcept;

  /// Energy stored by the memory force in the last press, N mm.
  double storedEnergy() const noexcept;
  /// The energy that would be stored with the strengths of each corner, N mm.
  Vector3 strengthEnergies() const noexcept;

private:
  Vector3 drag(const Vector3& contactPoint, const Vector3& normal) noexcept;
  /// The part of the force of the last press that remains if the stiffness of the curve is capped.
  /// `cappedSlow` (N) is the capped slow force, `maximumStiffness` (N/mm) the cap.
  double cappedForce(double cappedSlow, double maximumStiffness) const noexcept;
  /// Stiffness of the contact divided by the slow stiffness, for a loop that keeps the force
  /// constant between two ticks.
  double stiffening() const noexcept;
  void beginTick() noexcept;
  /// Continues at another point; the tool was not in contact in between.
  void jumpTo(const Place& place) noexcept;
  void exchange(double share) noexcept;
  void pressElements(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  void pressOne(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  /// The local depth at which the sum of local depth and C F is the depth of the tip.
  double localDepth(const BlendedResponse& curve) const noexcept;
  /// f - f_N of a curve.
  double restAt(const BlendedResponse& curve, double depth) const noexcept
  {
    return curve.evaluate(depth).force - this->Nodes.slowForce(this->Chords, depth);
  }
  /// 1/K for the QuasiLinearElement, chosen so that squares of forces are energies.
  double secantCompliance() const noexcept;

  const BodyRelaxation* Body;
  ForceNodes Nodes;
  bool IsOne; ///< quasi-linear: only one element
  bool IsInTime = false;

  double Elapsed = 0.0;
  double StepTime = -1.0; ///< time step of Step, s
  RelaxationStep Step;
  RelaxationElements Elements;
  QuasiLinearElement Rest; ///< the element of f - f_N
  QuasiLinearElement One;
  double OneDepth = 0.0; ///< depth of the last press with the one element
  double OneSlow = 0.0;  ///< slow force at OneDepth

  Place Last; ///< place of the last press
  bool HasBegun = false;
  bool WasTouched = false;
  double Compliance = 0.0; ///< elastic compliance in series, mm/N
  double Depth = 0.0;      ///< local
  double Slow = 0.0;       ///< f at Depth
  double Stiffness = 0.0;  ///< df/dδ at Depth
  double LastRest = 0.0;   ///< f - f_N at Depth
  double RestMemory = 0.0; ///< memory force of f - f_N
  Force Now;
  ForceNodes::Chords Chords;
  bool HasChords = false; ///< all chords are known, and are the same at all points
  SlidingDrag Drag;
};
} // namespace palpate

#endif
