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
 * The tip is projected on the undeformed surface (ContactTracker), and its distance is the
 * deflection δ. The curves of the triangle's three vertices are blended with the area coordinates
 * n_i of the projection (Mahvash and Hayward 2002, eqs. 3 and 4; ForceForm). Friction follows from
 * the motion of the contact point over the undeformed surface (Friction). Frictionless contacts
 * slide. Beyond an open border the contact is LostAtBorder and its force fades (BorderFade). If the
 * response has EdgeTerms, the contact leaves the body over sharp edges by BodyEdges. If the axis of
 * the tool is known and the response has tilt data, the tilt against the body's normal changes the
 * force and adds a torque (ContactTilt). On a body that relaxes, an update with the time since the
 * last update gives the force with memory (ContactRelaxation); an update without a time gives the
 * slow response.
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

  /// For a tool whose axis is taken to be the body's normal.
  Contact update(const Vector3& tip) noexcept { return this->update(ToolPose(tip)); }
  Contact update(const Vector3& tip, double elapsed) noexcept
  {
    return this->update(ToolPose(tip), elapsed);
  }
  /// The slow response; the memory of a body that relaxes is not changed.
  Contact update(const ToolPose& pose) noexcept { return this->feel(this->find(pose), 0.0); }
  /// The response `elapsed` s after the last update of this kind. If the first one finds the tip in
  /// the body, the tip is taken to have rested there.
  Contact update(const ToolPose& pose, double elapsed) noexcept
  {
    return this->feel(this->find(pose, elapsed), 0.0);
  }

  /// The first half of an update: finds the contact.
  ContactTracker::Result find(const ToolPose& pose) noexcept;
  ContactTracker::Result find(const ToolPose& pose, double elapsed) noexcept;
  /// The second half: the result for a found contact, where other forces have lowered the surface
  /// by `sunk` mm. To be called once after each find().
  Contact feel(ContactTracker::Result found, double sunk) noexcept;

  /// How the tool presses, for tools that lower the surface under one another.
  struct Pressed
  {
    ContactPlace place; ///< the contact; gradients of the area coordinates by the tip
    double depth = 0.0; ///< mm
    double share = 1.0; ///< fraction of the slow response left by edges and borders, approximate
  };
  /// Between find() and feel(): how the tool presses. Returns false if it does not press.
  bool press(const ContactTracker::Result& found, Pressed& pressed) noexcept;
  /// The slow response of the tool in its present tilt at a depth (mm) there.
  ResponseValue slowResponse(const Pressed& pressed, double depth) const noexcept;

  /// Lets time pass while the position of the tip is unknown.
  void pass(double elapsed) noexcept { this->Relaxation.pass(elapsed); }
  /// Forgets the contact, its friction, and the memory of the body.
  void reset() noexcept;
  /// Forgets the contact and its friction, but not the body's memory of having been pressed.
  void lose() noexcept;

  /// Prefetches the memory that the next update reads if the tip moves on as before. For the time
  /// when the force is sent and the loop is idle. Changes nothing; takes 50 ns to some
  /// microseconds.
  void foresee() const noexcept;
  /// Makes the next update on a copy that is discarded, as if the tip moved on as before. The data
  /// and code that the update reads are then in the cache, even if the processor was busy with
  /// other work. For a loop that waits for its next sample, `elapsed` s after the last. Changes
  /// nothing; costs an update.
  void rehearse(double elapsed) const noexcept;

  /// The curve at the contact of the last update. normalForce is its force at the deflection (a
  /// little less with ForceForm::Paper, a fraction of it beyond a border). Without a contact it is
  /// zero.
  BlendedResponse response() const noexcept
  {
    return { this->Body.response, this->LastCorners, this->LastWeights };
  }

  /// The fraction (0 to 1) of the force of that contact, friction included, that may remain if the
  /// stiffness seen by a loop is limited to `maximumStiffness`, N/mm (CappedResponse). For a body
  /// that relaxes, the instantaneous stiffness counts.
  double cappedShare(const Contact& contact, double maximumStiffness) const noexcept;

private:
  ContactTracker::Result follow(const ToolPose& pose) noexcept;
  bool isAtEdges(const ContactTracker::Result& found) const noexcept
  {
    return !this->IsWithoutEdges &&
      (found.outcome == ContactTracker::Outcome::Crease ||
        (found.outcome == ContactTracker::Outcome::Inside && this->Body.edges &&
          this->Body.edges->areNear(found.place.triangle)));
  }
  /// A contact that begins inside the body, where the law of edges leaves no force.
  Contact feelWithoutEdges() noexcept;
  /// Sets Sunk for a place: how much deeper the followed point is than the tool presses, by the
  /// lowering of the surface and by the tilt there.
  void sink(const ContactPlace& place) noexcept;
  /// Sets the gradients of facets if the force form needs them.
  void takeGradients(ContactPlace& place) const noexcept;
  /// Gradients of the area coordinates by the position of the tip.
  Eigen::Matrix3d weightGradients(const ContactPlace& place) const noexcept;
  /// Replaces the slow response there by the force with memory.
  void relax(const ContactPlace& place, const BlendedResponse& response, const ResponseValue& slow,
    Contact& result) noexcept;
  /// The contact near sharp edges or beyond one (BodyEdges).
  Contact feelEdges(ContactPlace& place) noexcept;
  EdgeEffect edgeEffect(ContactPlace& place) const noexcept;
  /// The same; the contact moves to the face across a blunt edge if that is nearer.
  EdgeEffect onNearestFace(ContactPlace& place) noexcept;
  /// Applies the effect of edges to a contact that was computed with their depth only.
  void applyEdges(
    const EdgeEffect& effect, const BlendedResponse& response, Contact& result) const noexcept;
  Contact end(ContactState state) noexcept;
  /// No contact, because the body has not yet come back to the tool.
  Contact comeOff() noexcept;
  /// Work done by the tool in its present tilt, N mm.
  double work(const BlendedResponse& response, double deflection) const noexcept
  {
    return this->Tilt.isTilted() ? this->Tilt.work() : response.energy(deflection);
  }
  /// Work of each corner's curve, plus the energy stored by memory there.
  Vector3 energies(const BlendedResponse& response, double deflection) const noexcept;
  /// The fade beyond an open border, and the depth there.
  BorderFade fadeAt(const ContactPlace& place) const noexcept;
  /// The force beyond an open border.
  Contact fade(ContactPlace& place) noexcept;
  void prefetchLast() const noexcept;
  void prefetchResponses(std::int32_t triangle) const noexcept;
  bool hasResponse(const ContactPlace& place) const noexcept;
  /// Fills everything except friction. Returns false if the force is not finite or has no
  /// direction. The state is None if a body that relaxes has not yet come back to the tool.
  bool blend(const ContactPlace& place, const BlendedResponse& response, Contact& result) noexcept;
  /// The vector from the tip to the contact point.
  Vector3 wayOut(const ContactPlace& place) const noexcept;
  /// The force of unlike curves, and that of edges, can point into the body: removes that part.
  void keepOutward(const ContactPlace& place, Contact& result) const noexcept;
  /// Σ n_i factor_i U_i.
  Vector3 sumOfNormals(const ContactPlace& place, const Vector3& factors) const noexcept;
  /// Adds torque and friction; `share` is the fraction of the energy left by edges and borders.
  void complete(const ContactPlace& place, const BlendedResponse& response, double share,
    Contact& result) noexcept;
  void addTorque(const ContactPlace& place, double share, Contact& result) const noexcept;
  void addFriction(const BlendedResponse& response, Contact& result) noexcept;

  const ContactBody& Body;
  ContactSettings Settings;
  ContactTracker Tracker;
  Friction Resistance;
  Vector3 LastTip = Vector3::Zero();  ///< the tip, or the followed point of a tilted tool
  Vector3 LastStep = Vector3::Zero(); ///< from the one before to it
  double LetDown = 0.0;               ///< lowering of the surface by others, mm
  double Sunk = 0.0;                  ///< LetDown plus the part of the tilt, mm
  /// An edge has released the tip. The next contact begins only after the tip has been outside: a
  /// contact that begins in the depth would return energy that was never put in.
  bool IsLetGo = false;
  bool IsNew = false; ///< the last update searched the whole body
  /// The contact began inside the body where the law of edges leaves no force, far below an edge or
  /// between bumps. It has no edges until the tip has been outside.
  bool IsWithoutEdges = false;
  TriangleCorners LastCorners{};
  Vector3 LastWeights = Vector3::Zero();
  bool IsInTime = false;
  ContactTilt Tilt;
  ContactRelaxation Relaxation; ///< last: most bodies have none
};
} // namespace palpate

#endif
