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
 * Computes the contact force from the tip's position, one tick after another.
 *
 * The tip is projected on the undeformed surface (ContactTracker); its distance from the surface is
 * the deflection δ. The curves of the triangle's three vertices are blended with the area
 * coordinates n_i of the projection (Mahvash and Hayward 2002, eqs. 3 and 4; ForceForm). Friction
 * depends on the motion of the contact point over the undeformed surface (Friction). Contacts
 * without friction slide. Beyond an open border the contact is LostAtBorder and its force fades
 * (BorderFade). If the response has EdgeTerms, BodyEdges controls how the contact leaves the body
 * over sharp edges. If the axis of the tool is known and the response has tilt data, the tilt
 * against the body's normal changes the force and adds a torque (ContactTilt). On a body that
 * relaxes, an update with the time since the last update results in the force with memory
 * (ContactRelaxation); an update without a time results in the slow response.
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

  /// For a tool whose axis is assumed to be parallel to the body's normal.
  Contact update(const Vector3& tip) noexcept { return this->update(ToolPose(tip)); }
  Contact update(const Vector3& tip, double elapsed) noexcept
  {
    return this->update(ToolPose(tip), elapsed);
  }
  /// Computes the slow response; the memory of a body that relaxes is not changed.
  Contact update(const ToolPose& pose) noexcept { return this->feel(this->find(pose), 0.0); }
  /// Computes the response `elapsed` s after the last update of this kind. If the first such update
  /// finds the tip inside the body, the tip is assumed to have rested there.
  Contact update(const ToolPose& pose, double elapsed) noexcept
  {
    return this->feel(this->find(pose, elapsed), 0.0);
  }

  /// First half of an update: finds the contact.
  ContactTracker::Result find(const ToolPose& pose) noexcept;
  ContactTracker::Result find(const ToolPose& pose, double elapsed) noexcept;
  /// Second half of an update: the result for a found contact if other forces have lowered the
  /// surface by `sunk` mm. To be called once after each find().
  Contact feel(ContactTracker::Result found, double sunk) noexcept;

  /// State of a tool that presses, for tools that lower the surface under one another.
  struct Pressed
  {
    ContactPlace place; ///< the contact; the gradients of the area coordinates are by the tip
    double depth = 0.0; ///< mm
    double share = 1.0; ///< fraction of the slow response that edges and borders leave, approximate
  };
  /// Finds how the tool presses; to be called between find() and feel(). Returns false if it does
  /// not press.
  bool press(const ContactTracker::Result& found, Pressed& pressed) noexcept;
  /// The slow response of the tool at a depth (mm) at that contact, in its present tilt.
  ResponseValue slowResponse(const Pressed& pressed, double depth) const noexcept;

  /// Adds time during which the position of the tip is unknown.
  void pass(double elapsed) noexcept { this->Relaxation.pass(elapsed); }
  /// Ends the contact, its friction, and the memory of the body.
  void reset() noexcept;
  /// Ends the contact and its friction, but keeps the memory of the body.
  void lose() noexcept;

  /// Prefetches the memory that the next update reads if the tip continues its motion. To be called
  /// after the force is sent, while the loop is idle. Changes nothing; takes 50 ns to a few
  /// microseconds.
  void foresee() const noexcept;
  /// Makes the next update on a copy that is discarded, as if the tip continued its motion. The
  /// data and code that the update uses are then in the cache, even if the processor was busy with
  /// other work. It serves a loop that waits for its next sample, `elapsed` s after the last one.
  /// Changes nothing; costs an update.
  void rehearse(double elapsed) const noexcept;

  /// The curve at the contact of the last update. normalForce is its force at the deflection
  /// (slightly less with ForceForm::Paper, a fraction beyond a border). Without a contact the curve
  /// is zero.
  BlendedResponse response() const noexcept
  {
    return { this->Body.response, this->LastCorners, this->LastWeights };
  }

  /// The fraction (0 to 1) of the force of the contact of the last update, friction included, that
  /// remains if the stiffness that acts in a loop is limited to `maximumStiffness`, N/mm
  /// (CappedResponse). For a body that relaxes, the instantaneous stiffness is limited.
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
  /// Starts a contact inside the body at a point at which the law of edges leaves no force.
  Contact feelWithoutEdges() noexcept;
  /// Sets Sunk: by how much the followed point is deeper than the tool presses at a contact,
  /// because of the lowering of the surface and of the tilt.
  void sink(const ContactPlace& place) noexcept;
  /// Sets the gradients of facets if the force form needs them.
  void setGradients(ContactPlace& place) const noexcept;
  /// Gradients of the area coordinates by the position of the tip.
  Eigen::Matrix3d weightGradients(const ContactPlace& place) const noexcept;
  /// Replaces the slow response of `result` by the force with memory.
  void relax(const ContactPlace& place, const BlendedResponse& response, const ResponseValue& slow,
    Contact& result) noexcept;
  /// The contact near sharp edges or beyond one (BodyEdges).
  Contact feelEdges(ContactPlace& place) noexcept;
  EdgeEffect edgeEffect(ContactPlace& place) const noexcept;
  /// As edgeEffect(); the contact moves to the face across a blunt edge if that face is nearer.
  EdgeEffect onNearestFace(ContactPlace& place) noexcept;
  /// Applies the effect of edges to a contact for which only the depth of that effect was used.
  void applyEdges(
    const EdgeEffect& effect, const BlendedResponse& response, Contact& result) const noexcept;
  Contact end(ContactState state) noexcept;
  /// Ends the contact because the body has not yet recovered to the tool.
  Contact endDetached() noexcept;
  /// Work done by the tool in its present tilt, N mm.
  double work(const BlendedResponse& response, double deflection) const noexcept
  {
    return this->Tilt.isTilted() ? this->Tilt.work() : response.energy(deflection);
  }
  /// Work of each corner's curve, plus the energy stored there by the memory force.
  Vector3 energies(const BlendedResponse& response, double deflection) const noexcept;
  /// The fade beyond an open border, and the depth below the border.
  BorderFade fadeAt(const ContactPlace& place) const noexcept;
  /// The contact beyond an open border.
  Contact fade(ContactPlace& place) noexcept;
  void prefetchLast() const noexcept;
  void prefetchResponses(std::int32_t triangle) const noexcept;
  bool hasResponse(const ContactPlace& place) const noexcept;
  /// Sets all results except friction. Returns false if the force is not finite or has no
  /// direction. The state is None if a body that relaxes has not yet recovered to the tool.
  bool blend(const ContactPlace& place, const BlendedResponse& response, Contact& result) noexcept;
  /// The vector from the tip to the contact point.
  Vector3 vectorToContact(const ContactPlace& place) const noexcept;
  /// Removes the part of the force that points into the body, which different curves and edges can
  /// cause.
  void keepOutward(const ContactPlace& place, Contact& result) const noexcept;
  /// Σ n_i factor_i U_i.
  Vector3 sumOfNormals(const ContactPlace& place, const Vector3& factors) const noexcept;
  /// Adds torque and friction; `share` is the fraction of the energy that edges and borders leave.
  void complete(const ContactPlace& place, const BlendedResponse& response, double share,
    Contact& result) noexcept;
  void addTorque(const ContactPlace& place, double share, Contact& result) const noexcept;
  void addFriction(const BlendedResponse& response, Contact& result) noexcept;

  const ContactBody& Body;
  ContactSettings Settings;
  ContactTracker Tracker;
  Friction Resistance;
  Vector3 LastTip = Vector3::Zero();  ///< the tip, or the followed point of a tilted tool
  Vector3 LastStep = Vector3::Zero(); ///< from the preceding tip to LastTip
  double Lowering = 0.0;              ///< lowering of the surface by other tools, mm
  double Sunk = 0.0;                  ///< Lowering plus the effect of the tilt, mm
  /// An edge has released the tip. The next contact begins only after the tip has been outside: a
  /// contact that begins at a depth would return energy that was never put in.
  bool IsReleased = false;
  bool IsNew = false; ///< the last update searched the whole body
  /// The contact began inside the body at a point at which the law of edges leaves no force, far
  /// below an edge or between bumps. Edges have no effect on it until the tip has been outside.
  bool IsWithoutEdges = false;
  TriangleCorners LastCorners{};
  Vector3 LastWeights = Vector3::Zero();
  bool IsInTime = false;
  ContactTilt Tilt;
  ContactRelaxation Relaxation; ///< last member, because most bodies do not relax
};
} // namespace palpate

#endif
