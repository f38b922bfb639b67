// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ToolContact_h
#define palpate_ToolContact_h

#include "Contact/ContactBody.h"
#include "Contact/Contact.h"
#include "Contact/ContactSettings.h"
#include "Contact/ContactTracker.h"
#include "Contact/Friction.h"
#include "Contact/Relaxation/ContactRelaxation.h"
#include "Contact/Tilt/ContactTilt.h"
#include "Mechanics/PalpateExport.h"

#include <cstdint>

namespace palpate
{
struct BorderFade;

/**
 * One tick: tip position in, contact force out.
 *
 * The tip is projected on the undeformed surface (ContactTracker), its distance is
 * the deflection δ, and the curves of the triangle's three vertices are blended with the area
 * coordinates n_i of the projection (Mahvash and Hayward 2002, eqs. 3 and 4; ForceForm). Friction
 * follows from how the contact point moves over the undeformed surface (Friction). Frictionless
 * contacts slide. Beyond an open border the contact is LostAtBorder and its force fades
 * (BorderFade). Over the sharp edges of a body whose response has EdgeTerms it leaves as BodyEdges
 * tells. A tool whose axis is known is tilted against the body's normal, if the response knows of
 * tilts (ContactTilt): its force is another, and it has a torque. A body that relaxes is felt in
 * time by an update that is told how long ago the last one was (ContactRelaxation); without a time
 * it is its slow response.
 *
 * update() neither allocates nor locks nor throws. One ToolContact is one history and serves one
 * thread; the body may be shared and must outlive it.
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

  /// Of a tool whose axis is taken to be the body's normal.
  Contact update(const Vector3& tip) noexcept { return this->update(ToolPose(tip)); }
  Contact update(const Vector3& tip, double elapsed) noexcept
  {
    return this->update(ToolPose(tip), elapsed);
  }
  /// The slow response; what the body remembers of time stays as it is.
  Contact update(const ToolPose& pose) noexcept { return this->feel(this->find(pose), 0.0); }
  /// `elapsed` s after the last of these. The first one that finds the tip in the body takes it to
  /// have rested there.
  Contact update(const ToolPose& pose, double elapsed) noexcept
  {
    return this->feel(this->find(pose, elapsed), 0.0);
  }

  /// The first half of an update: where the tool touches.
  ContactTracker::Result find(const ToolPose& pose) noexcept;
  ContactTracker::Result find(const ToolPose& pose, double elapsed) noexcept;
  /// The second half: what it feels there, where something else has let the surface down by
  /// `sunk` mm. Once after each find.
  Contact feel(ContactTracker::Result found, double sunk) noexcept;

  /// How the tool presses, for tools that let the surface down under one another.
  struct Pressed
  {
    ContactPlace place; ///< where, with the gradients of its area coordinates as the tip moves
    double depth = 0.0; ///< mm
    double share = 1.0; ///< of the slow response at this depth, about: edges and borders leave it
  };
  /// Between the two halves; false where nothing is pressed.
  bool press(const ContactTracker::Result& found, Pressed& pressed) noexcept;
  /// The slow response of the tool, as it is tilted, so deep there (mm).
  ResponseValue slowResponse(const Pressed& pressed, double depth) const noexcept;

  /// Lets time pass while the position of the tip is not known.
  void pass(double elapsed) noexcept { this->Relaxation.pass(elapsed); }
  /// Forgets the contact, its friction, and what the body remembers.
  void reset() noexcept;
  /// Forgets the contact and its friction, not what the body remembers of having been pressed.
  void lose() noexcept;

  /// Asks for the memory which the next update reads if the tip moves on as it did: for when the
  /// force is sent and the loop has nothing to do. Changes nothing; takes 50 ns to some
  /// microseconds.
  void foresee() const noexcept;
  /// Makes the next update, if the tip moves on as it did, on a copy that is thrown away: what it
  /// reads, code too, is at hand then, however busy the processor was with other things. For a loop
  /// that waits for its next sample, `elapsed` s after the last. Changes nothing; costs an update.
  void rehearse(double elapsed) const noexcept;

  /// The curve at the contact of the last update: normalForce is its force at the deflection (with
  /// ForceForm::Paper a little less, beyond a border a share of it). Without a contact it is zero.
  BlendedResponse response() const noexcept
  {
    return { this->Body.response, this->LastCorners, this->LastWeights };
  }

  /// Of the force of that contact, friction included, so much may stay where the stiffness that a
  /// loop feels is to be no larger than this, N/mm: 0 to 1 (CappedResponse). Of a body that relaxes
  /// its instantaneous stiffness counts.
  double cappedShare(const Contact& contact, double maximumStiffness) const noexcept;

private:
  ContactTracker::Result follow(const ToolPose& pose) noexcept;
  bool isAtEdges(const ContactTracker::Result& found) const noexcept
  {
    return found.outcome == ContactTracker::Outcome::Crease ||
      (found.outcome == ContactTracker::Outcome::Inside && this->Body.edges &&
        this->Body.edges->areNear(found.place.triangle));
  }
  /// By how much the point followed is deeper than the tool presses: what it was let down, and what
  /// the tilt there takes.
  void sink(const ContactPlace& place) noexcept;
  /// The gradients of facets, where the force form needs them.
  void takeGradients(ContactPlace& place) const noexcept;
  /// Gradients of the area coordinates as the tip moves.
  Eigen::Matrix3d weightGradients(const ContactPlace& place) const noexcept;
  /// What memory makes of the slow response there.
  void relax(const ContactPlace& place, const BlendedResponse& response, const ResponseValue& slow,
    Contact& result) noexcept;
  /// The force where sharp edges are near, or beyond one (BodyEdges).
  Contact feelEdges(ContactPlace& place) noexcept;
  EdgeEffect edgeEffect(ContactPlace& place) const noexcept;
  /// The same; the contact goes over to the face across a blunt edge, where that is nearer.
  EdgeEffect onNearestFace(ContactPlace& place) noexcept;
  /// What edges make of a contact that knows nothing of them but its depth.
  void applyEdges(
    const EdgeEffect& effect, const BlendedResponse& response, Contact& result) const noexcept;
  Contact end(ContactState state) noexcept;
  /// No contact, since the body has not yet come back to the tool.
  Contact comeOff() noexcept;
  /// Work that the tool as it is tilted has taken, N mm.
  double work(const BlendedResponse& response, double deflection) const noexcept
  {
    return this->Tilt.isTilted() ? this->Tilt.work() : response.energy(deflection);
  }
  /// Work of each corner's curve, and what memory stores there.
  Vector3 energies(const BlendedResponse& response, double deflection) const noexcept;
  /// How much is left beyond an open border, and how deep it is there.
  BorderFade fadeAt(const ContactPlace& place) const noexcept;
  /// The force beyond an open border.
  Contact fade(ContactPlace& place) noexcept;
  void prefetchLast() const noexcept;
  void prefetchResponses(std::int32_t triangle) const noexcept;
  bool hasResponse(const ContactPlace& place) const noexcept;
  /// Fills everything but friction; false where the force is not finite or has no direction. The
  /// state is None where a body that relaxes has not yet come back to the tool.
  bool blend(const ContactPlace& place, const BlendedResponse& response, Contact& result) noexcept;
  /// From the tip to the contact point.
  Vector3 wayOut(const ContactPlace& place) const noexcept;
  /// The force of unlike curves, and that of edges, can lead into the body: without that part.
  void keepOutward(const ContactPlace& place, Contact& result) const noexcept;
  /// Σ n_i factor_i U_i.
  Vector3 sumOfNormals(const ContactPlace& place, const Vector3& factors) const noexcept;
  /// Torque and friction; `share` of the energy is left, as edges and borders have it.
  void complete(const ContactPlace& place, const BlendedResponse& response, double share,
    Contact& result) noexcept;
  void addTorque(const ContactPlace& place, double share, Contact& result) const noexcept;
  void addFriction(const BlendedResponse& response, Contact& result) noexcept;

  const ContactBody& Body;
  ContactSettings Settings;
  ContactTracker Tracker;
  Friction Resistance;
  Vector3 LastTip = Vector3::Zero();  ///< or what is followed of a tool that is tilted
  Vector3 LastStep = Vector3::Zero(); ///< to it from the one before
  double LetDown = 0.0;               ///< the surface, by others, mm
  double Sunk = 0.0;                  ///< that, and by the tilt
  /// An edge let go of the tip: another contact begins when it has been outside, since one that
  /// begins in the depth would give what nobody has put in.
  bool IsLetGo = false;
  TriangleCorners LastCorners{};
  Vector3 LastWeights = Vector3::Zero();
  bool IsInTime = false;
  ContactTilt Tilt;
  ContactRelaxation Relaxation; ///< last: most bodies have none
};
} // namespace palpate

#endif
