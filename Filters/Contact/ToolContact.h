// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolContact_h
#define palpate_ToolContact_h

#include "Contact/Contact.h"
#include "Contact/ContactBody.h"
#include "Contact/ContactSettings.h"
#include "Contact/ContactTracker.h"
#include "Contact/Friction.h"
#include "Contact/Jet.h"
#include "Contact/Pressed.h"
#include "Contact/Relaxation/ContactRelaxation.h"
#include "Contact/Tilt/ContactTilt.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>

namespace palpate
{
/**
 * Computes the contact force from the tip's position, tick by tick.
 *
 * The tip is projected on the undeformed surface (ContactTracker); its distance from the surface is
 * the deflection δ. The curves of the triangle's three vertices are combined with the area
 * coordinates n_i of the projection as weights (Mahvash and Hayward 2002, eqs. 3 and 4; ForceForm).
 * Friction depends on the motion of the contact point over the undeformed surface (Friction).
 * Contacts without friction are in the state Slide. Beyond an open border the state is LostAtBorder
 * and the force fades (BorderFade). If the response has EdgeTerms, BodyEdges controls how the
 * contact leaves the body over sharp edges. If the axis of the tool is known and the response has
 * tilt data, the angle between the axis and the body's normal changes the force and adds a torque
 * (ContactTilt). On a body that relaxes, an update with the time since the last update computes the
 * force with memory (ContactRelaxation); an update without a time computes the slow response.
 *
 * All effects are combined in one work function (Jet): the work of the upright tool, times the
 * factor of the tilt, plus the energy of the memory, times the factor of edges or border. Its
 * derivatives are the normal force, the stiffness, the moment and the force along the surface.
 *
 * update() neither allocates, locks nor throws. One ToolContact stores the history of one contact
 * and is used by one thread. Several ToolContacts may share the body, which must outlive them.
 */
class PALPATE_EXPORT ToolContact
{
public:
  explicit ToolContact(const ContactBody& body, const ContactSettings& settings = {})
    : Body(body)
    , Settings(settings)
    , Tracker(settings.surface == ContactSurface::Smooth
          ? ContactTracker(body.surface, body.tree, body.response)
          : ContactTracker(body.surface, body.tree))
    , Resistance(settings.friction)
    , Tilt(body.tilt.get())
    , Relaxation(body.relaxation.get(), settings.relaxationElements)
  {
  }

  /// For a tool whose axis is assumed to be parallel to the body's normal.
  Contact update(const Vector3& tip) noexcept { return this->update(ToolPose(tip)); }
  Contact update(const Vector3& tip, double elapsed) noexcept
  {
    return this->update(ToolPose(tip), elapsed);
  }
  /// Computes the slow response. The memory of a body that relaxes is not changed.
  Contact update(const ToolPose& pose) noexcept
  {
    Pressed at = this->find(pose);
    return this->feel(at, 0.0);
  }
  /// Computes the response `elapsed` s after the last update with a time. If the first such update
  /// finds the tip inside the body, the tip is assumed to have been at rest there.
  Contact update(const ToolPose& pose, double elapsed) noexcept
  {
    Pressed at = this->find(pose, elapsed);
    return this->feel(at, 0.0);
  }

  /// First half of an update: finds the contact point.
  Pressed find(const ToolPose& pose) noexcept;
  Pressed find(const ToolPose& pose, double elapsed) noexcept;
  /// Second half of an update: computes the result for a contact of find(). `lowering` is the
  /// lowering of the surface by other forces, mm. To be called once after each find().
  Contact feel(Pressed& at, double lowering) noexcept;

  /// Computes the depth of the tool on a surface that is not lowered by other tools. Used for tools
  /// that lower the surface under one another. To be called between find() and feel(). Returns
  /// false if the tool does not press.
  bool press(Pressed& at) noexcept;
  /// Returns the slow response of the tool at the contact `at` for another depth (mm), with the
  /// present tilt.
  ResponseValue slowResponse(const Pressed& at, double depth) const noexcept;

  /// Adds time (s) during which the position of the tip is unknown.
  void pass(double elapsed) noexcept { this->Relaxation.pass(elapsed); }
  /// Ends the contact and its friction, and resets the memory of the body.
  void reset() noexcept;
  /// Ends the contact and its friction, but keeps the memory of the body.
  void lose() noexcept;

  /// Takes over the friction state of another contact at the same point (Friction::assume).
  void assumeFriction(const ToolContact& other) noexcept
  {
    this->Resistance.assume(other.Resistance);
  }

  /// Prefetches the memory that the next update reads if the tip continues its motion. To be called
  /// after the force is sent, while the loop is idle. Changes no state; takes 50 ns to a few
  /// microseconds.
  void foresee() const noexcept;
  /// Computes the next update on a copy that is discarded, as if the tip continued its motion. Then
  /// the data and the code of the update are in the cache, even if the processor was busy with
  /// other work. Used by a loop that waits for its next sample, `elapsed` s after the last one.
  /// Changes no state; costs as much as an update.
  void rehearse(double elapsed) const noexcept;

  /// Returns the curve at the contact of the last update; zero if there is no contact. normalForce
  /// is the force of this curve at the deflection (slightly less with ForceForm::Paper, a fraction
  /// of it beyond a border).
  BlendedResponse response() const noexcept
  {
    return { this->Body.response, this->LastCorners, this->LastWeights };
  }

  /// Returns the fraction (0 to 1) of the force of the last update, including friction, that
  /// remains if the stiffness in the loop is limited to `maximumStiffness`, N/mm (CappedResponse).
  /// For a body that relaxes, the instantaneous stiffness is limited.
  double cappedShare(const Contact& contact, double maximumStiffness) const noexcept;

private:
  Pressed follow(const ToolPose& pose) noexcept;
  bool hasResponse(const ContactPlace& place) const noexcept;
  BlendedResponse curvesAt(const ContactPlace& place) const noexcept
  {
    return { this->Body.response, this->Body.surface.corners(place.triangle),
      place.projection.weights };
  }

  /// Computes the depth of the tool, and the factor by which edges or a border change its work.
  void reach(Pressed& at, double lowering) noexcept;
  /// Moves the contact to the face across a blunt edge, repeatedly as long as that face is nearer.
  void crossEdges(Pressed& at, double lowering) noexcept;
  /// Returns whether the force has a part that depends on the gradients of the area coordinates.
  bool usesGradients(const ContactPlace& place) const noexcept
  {
    return this->Settings.form == ForceForm::EnergyConsistent ||
      (this->Settings.form == ForceForm::NormalizedDirection && place.isSmooth);
  }
  /// Returns the slow work at a depth > 0 with the present tilt. Its value is computed only if an
  /// effect needs it.
  Jet slowWork(const Pressed& at, double depth, const ResponseValue& upright) const noexcept;
  /// Adds the memory force and energy of a body that relaxes to a slow work.
  void addMemory(Jet& work, const Pressed& at, Contact& result) noexcept;
  /// Sets all results except friction. Returns false if the force is not finite or has no
  /// direction. While a relaxing body is still dented below the tool, the state is None.
  bool push(const Pressed& at, Contact& result) noexcept;
  void addFriction(Contact& result) noexcept;
  /// Returns the vector from the tip to the contact point.
  Vector3 vectorToContact(const ContactPlace& place) const noexcept;

  /// Returns the result of a tool that does not press.
  Contact endAtDepth(const Pressed& at, double lowering) noexcept;
  Contact end(ContactState state) noexcept;
  /// Ends the contact because the body is still dented below the tool.
  Contact endDetached() noexcept;

  /// Effect of edges on a contact. The mode becomes Active again when the tip has been outside the
  /// body.
  enum class EdgeMode : std::uint8_t
  {
    Active,
    /// The contact has ended at an edge. A new contact that begins at a depth > 0 would return
    /// energy that was never put in.
    Released,
    /// The contact began inside the body at a point at which the edge law gives no force, far below
    /// an edge or between bumps.
    Ignored
  };

  const ContactBody& Body;
  ContactSettings Settings;
  ContactTracker Tracker;
  Friction Resistance;
  Vector3 LastTip = Vector3::Zero();  ///< tip, or followed point of a tilted tool
  Vector3 LastStep = Vector3::Zero(); ///< vector from the preceding LastTip to LastTip
  EdgeMode Edges = EdgeMode::Active;
  TriangleCorners LastCorners{};
  Vector3 LastWeights = Vector3::Zero();
  /// Slow response at the last contact, without the effect of edges and borders.
  ResponseValue Slow;
  ContactTilt Tilt;
  ContactRelaxation Relaxation; ///< the last member, because most bodies do not relax
};
} // namespace palpate

#endif
