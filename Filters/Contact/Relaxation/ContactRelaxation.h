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
 * The contact sticks with the tangential stiffness of the body until the tangential force equals
 * the energy that new material stores per unit length of the path.
 *
 * The stiffness changes with the depth. When the spring gets stiffer, it keeps its force; when it
 * gets softer, it keeps its displacement. Therefore no change creates energy (as in ShapeFriction).
 * Only sliding moves the contact to new material: a small motion back and forth does not reach new
 * material.
 */
class SlidingDrag
{
public:
  void reset() noexcept
  {
    this->Frame.reset();
    this->Displacement.setZero();
  }

  /// Moves to the contact point of this tick. Returns the length of the path from the last contact
  /// point, mm; 0 for the first contact after reset().
  double advance(const Vector3& contactPoint, const Vector3& normal) noexcept
  {
    if (!this->Frame.advance(contactPoint, normal))
    {
      this->Displacement.setZero();
      this->Stiffness = 0.0;
    }
    return this->Frame.step().length();
  }

  /// Slides along the path of the last advance(). `limit` is the largest tangential force, N.
  /// `stiffness` is the tangential stiffness, N/mm. Returns the length of the sliding part of the
  /// path, mm.
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

  /// Returns the force on the tool, N.
  Vector3 force() const noexcept
  {
    return -this->Stiffness * this->Frame.toSpace(this->Displacement);
  }

private:
  static constexpr double Shortest = 1e-12; ///< mm

  FrictionFrame Frame;
  Vector2 Displacement = Vector2::Zero(); ///< elastic part of the displacement, mm
  double Stiffness = 0.0;
};

/**
 * Computes the force of one contact on a body that relaxes, tick by tick.
 *
 * The stored curve f is the slow response. Parallel elements (RelaxationElements) carry the memory
 * force; each element separates from the tool independently. The slow force f_N of the elements
 * approximates f by chords. The remainder f - f_N relaxes as one quasi-linear branch (QLV). The
 * force F = Σ w_j q_j + (f - f_N) + QLV[f - f_N] is at least 0, and it is 0 when the first element
 * separates. Loading is exact for any number of elements. On release the contact ends before the
 * tool has left the dent, and the dent then recovers without contact. The three curves of a
 * triangle share one memory, because q depends only on depth and time. The following errors are the
 * largest over ramps, holds, releases, triangular and sinusoidal cycles, and random presses of
 * three materials (P up to 4), as a fraction of the largest force, for a sphere and a cone: 0.40
 * and 0.91 % with 16 elements, 1.3 and 3.0 % with 8, and 10 and 12 % with the quasi-linear law (no
 * elements). For a flat end the error is 0.01 % in all cases.
 *
 * With an elastic compliance C in series, the equation δ = δ_local + C F is solved, and only the
 * local part relaxes.
 *
 * Sliding moves the tool to new material, which counts as newly pressed, so that the force
 * increases. Over a path of length s a fraction λ = 1 - e^(-s/2a) of the elements is exchanged,
 * where a is the contact radius. The work of the drag force supplies the energy for this
 * (SlidingDrag). Compared with a half-space of 3-D cells, the error is -5.3 to 4.7 % of (1 + P) f
 * for a sphere and a cone.
 *
 * Energy: for any increasing curve and any motion, elements and quasi-linear branches return at
 * most the energy that was put in. If the strength differs from point to point, the stored energy
 * also differs; strengthEnergies() returns the data for the resulting sideways force.
 *
 * Sources: Lee and Radok 1960; Ting 1966; Fung 1981. No function allocates or throws. One object
 * stores the history of one contact.
 */
class PALPATE_EXPORT ContactRelaxation
{
public:
  /// `body` must outlive this object; it is null if the body does not relax. If `elements` <= 0,
  /// the quasi-linear law is used.
  ContactRelaxation(const BodyRelaxation* body, int elements) noexcept;

  /// Selects whether the next tick includes the memory force, if the body relaxes. Without the
  /// memory force, lift() and slide() have no effect.
  void setInTime(bool is) noexcept { this->IsInTime = is && this->Body; }
  bool isInTime() const noexcept { return this->IsInTime; }
  /// Resets the memory. The next contact is assumed to have been at rest at the point where it is
  /// found.
  void reset() noexcept;

  /// Adds `elapsed` (s) to the time that the next press() or lift() takes into account. Used also
  /// while the position of the tip is unknown.
  void pass(double elapsed) noexcept { this->Elapsed += elapsed > 0.0 ? elapsed : 0.0; }
  /// Advances the relaxation by one tick without contact.
  void lift() noexcept;
  /// Ends the contact, but keeps the memory of the body.
  void lose() noexcept
  {
    this->WasTouched = false;
    this->Drag.reset();
  }

  /// Position of a contact: its triangle, area coordinates and deflection.
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
    bool isTouched = false; ///< false while the material is still dented below the tool
  };
  /// Computes one tick in contact. `slow` is the value of the response at the deflection of
  /// `place`.
  Force press(const Place& place, const ResponseValue& slow) noexcept;

  /// Moves the tool along the surface. To be called after press(). Returns the sideways force on
  /// the tool, N.
  Vector3 slide(const Vector3& contactPoint, const Vector3& normal) noexcept
  {
    return this->IsInTime ? this->drag(contactPoint, normal) : Vector3(Vector3::Zero());
  }

  /// Returns the fraction (0 to 1) of the force at `depth` on the curve that remains if the
  /// stiffness is limited to `maximumStiffness`, N/mm. The force includes the memory force of the
  /// last press, if there is any.
  double cappedShare(
    const BlendedResponse& curve, double depth, double maximumStiffness) const noexcept;

  /// Returns the energy stored by the memory force in the last press, N mm.
  double storedEnergy() const noexcept;
  /// Returns the energies that would be stored with the strengths of each of the three corners, N
  /// mm.
  Vector3 strengthEnergies() const noexcept;

private:
  Vector3 drag(const Vector3& contactPoint, const Vector3& normal) noexcept;
  /// Returns the part of the force of the last press that remains if the stiffness of the curve is
  /// limited, N. `cappedSlow` is the slow force with this limit, N. `maximumStiffness` is the
  /// limit, N/mm.
  double cappedForce(double cappedSlow, double maximumStiffness) const noexcept;
  /// Returns the stiffness of the contact divided by the slow stiffness, for a loop that keeps the
  /// force constant between two ticks.
  double stiffening() const noexcept;
  void beginTick() noexcept;
  /// Moves the memory to another point, when the tool was not in contact between the last tick and
  /// this one.
  void jumpTo(const Place& place) noexcept;
  void exchange(double share) noexcept;
  void pressElements(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  void pressOne(const BlendedResponse& curve, const ResponseValue& slow) noexcept;
  /// Returns the local depth d for which d + C F(d) is the depth of the tip, mm.
  double localDepth(const BlendedResponse& curve) const noexcept;
  /// Returns f - f_N of a curve, N.
  double restAt(const BlendedResponse& curve, double depth) const noexcept
  {
    return curve.evaluate(depth).force - this->Nodes.slowForce(this->Chords, depth);
  }
  /// Returns 1/K for the QuasiLinearElement, mm/N, chosen so that squared forces times 1/K are
  /// energies.
  double secantCompliance() const noexcept;

  const BodyRelaxation* Body;
  ForceNodes Nodes;
  bool IsOne; ///< quasi-linear law: there is only one element
  bool IsInTime = false;

  double Elapsed = 0.0;
  double StepTime = -1.0; ///< time step for which Step was computed, s
  RelaxationStep Step;
  RelaxationElements Elements;
  QuasiLinearElement Rest; ///< element for the remainder f - f_N
  QuasiLinearElement One;
  double OneDepth = 0.0; ///< depth of the last press with the single element
  double OneSlow = 0.0;  ///< slow force at OneDepth

  Place Last; ///< position of the last press
  bool HasBegun = false;
  bool WasTouched = false;
  double Compliance = 0.0; ///< elastic compliance in series, mm/N
  double Depth = 0.0;      ///< local depth
  double Slow = 0.0;       ///< f at Depth
  double Stiffness = 0.0;  ///< df/dδ at Depth
  double LastRest = 0.0;   ///< f - f_N at Depth
  double RestMemory = 0.0; ///< memory force of f - f_N
  Force Now;
  ForceNodes::Chords Chords;
  bool HasChords = false; ///< whether all chords are known and are the same at all points
  SlidingDrag Drag;
};
} // namespace palpate

#endif
