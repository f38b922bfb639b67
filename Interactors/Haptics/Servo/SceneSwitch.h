// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SceneSwitch_h
#define palpate_SceneSwitch_h

#include "Haptics/Safety/SafetyLinks.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/Coupled/CoupledContacts.h"

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace palpate
{
/**
 * A body with the response of a tool, as one ServoStep renders it. Another body, tool or material,
 * or other settings, are another scene. Scenes are made and freed outside the tick; the tick only
 * passes them on.
 */
struct ServoScene
{
  static constexpr std::size_t MostHands = 4;

  /// `contactBody` must not be null; the scene shares its ownership. `sceneForceFactor` (0, 1] fits
  /// this scene to the device, in addition to SafetySettings::forceFactor: the force is multiplied
  /// by both. A factor out of its range counts as 0: no force. `hands`: the number of devices, each
  /// with one contact; clamped to the range 1 to MostHands.
  explicit ServoScene(std::shared_ptr<const ContactBody> contactBody,
    const ContactSettings& contactSettings = {}, double sceneForceFactor = 1.0,
    std::size_t hands = 1)
    : body(std::move(contactBody))
    , settings(contactSettings)
    , contacts(*this->body, contactSettings, std::min(hands, MostHands))
    , rehearsed(this->contacts)
    , forceFactor(sceneForceFactor > 0.0 && sceneForceFactor <= 1.0 ? sceneForceFactor : 0.0)
  {
  }
  ~ServoScene()
  {
    // One by one, because a recursion would be as deep as the list is long.
    while (this->next)
    {
      this->next = std::move(this->next->next);
    }
  }
  /// Copies the scene and its history, but not the list.
  ServoScene(const ServoScene& other)
    : body(other.body)
    , settings(other.settings)
    , contacts(other.contacts)
    , rehearsed(other.rehearsed)
    , forceFactor(other.forceFactor)
  {
  }
  ServoScene& operator=(const ServoScene&) = delete;

  const std::shared_ptr<const ContactBody> body;
  const ContactSettings settings;
  CoupledContacts contacts;
  CoupledContacts rehearsed; ///< a copy of `contacts` with a tick made in advance
  const double forceFactor;
  /// The next scene in a list of scenes that are no longer needed: freeing the first scene frees
  /// all.
  std::unique_ptr<ServoScene> next;
};

/// The largest stiffness that a scene may have at a force factor of 1; the body's frame.
struct StiffnessLimits
{
  double straight = std::numeric_limits<double>::infinity(); ///< N/mm
  double turning = std::numeric_limits<double>::infinity();  ///< N mm/rad
};

/// The fraction (0 to 1) of a contact's torque that remains if the torsional stiffness that acts in
/// a loop is limited to `limit`, N mm/rad. This stiffness is assumed to be |M|/θ, because no better
/// value is known; it is exact for a flat end in full contact.
inline double cappedTorqueShare(const Contact& contact, double limit) noexcept
{
  const double torque = contact.torque.norm();
  const double most = limit * contact.tilt; // NaN if the limit is infinite and the tilt zero
  return most < torque ? most / torque : 1.0;
}

/// The force of a scene on one tip, or the blend of two scenes during a change. Body frame; mm, N.
struct SceneForce
{
  Contact contact;                        ///< contact of the newest scene
  Vector3 idealForce = Vector3::Zero();   ///< blended; contact.force outside a change
  Vector3 cappedForce = Vector3::Zero();  ///< blended, with each stiffness capped
  Vector3 idealTorque = Vector3::Zero();  ///< about the tip, N mm; blended
  Vector3 cappedTorque = Vector3::Zero(); ///< blended, with each torsional stiffness capped
  double forceFactor = 1.0;               ///< blended; 0: no force
  double share = 1.0;                     ///< fraction of idealForce from the newest scene
  /// The longest displacement (mm) over which the contact can return work: the deflection, the
  /// lowering of the surface by the other hands, and the elastic displacement of the friction.
  double reach = 0.0;
  bool outside = true;   ///< no contact
  bool changing = false; ///< the fraction differs from that of the last tick
};

/**
 * The scene of a ServoStep, and its change to another scene while tips may be in contact.
 *
 * The force on each hand changes from the old scene to the new one within 50 ms (ForceRamp). The
 * contacts of both scenes are computed at the present tips. The sent force is (1-w) φ F of the old
 * scene plus w φ' F' of the new one, where w grows linearly in time and φ, φ' are the force
 * factors. Therefore the force changes per tick by at most |φ'F' - φF| T / 50 ms, in addition to
 * the blended changes of both forces by motion. No tick is stiffer than the stiffer of the two
 * scenes.
 *
 * The new contact begins at the position of the old one: under the same side of a thin body, if
 * both bodies have that side. The new contact continues with the pre-sliding displacement
 * of the old one (Friction::assume), within its own limit of friction. A
 * scene that is passed during a ramp waits for the end of the ramp. Otherwise a third contact would
 * be necessary, or a force that does not respond to the hand. If several scenes wait, the newest is
 * used.
 *
 * The contacts of a hand without a pose are kept in both scenes, and time passes for them. While no
 * hand has a pose, the ramp does not advance.
 *
 * Only the constructors allocate or free memory; a tick of a ramp costs two contacts per hand.
 */
class PALPATE_EXPORT SceneSwitch
{
public:
  /// `scene` must not be null.
  explicit SceneSwitch(std::unique_ptr<ServoScene> scene) noexcept;
  /// Copies the scenes, except those that are no longer needed.
  SceneSwitch(const SceneSwitch& other);
  SceneSwitch(SceneSwitch&& other) noexcept = default;
  SceneSwitch& operator=(const SceneSwitch&) = delete;
  SceneSwitch& operator=(SceneSwitch&&) = delete;
  ~SceneSwitch() = default;

  /// Number of hands of all scenes.
  std::size_t hands() const noexcept { return this->Current->contacts.count(); }

  /// Makes one tick, `elapsed` s after the last, with one pose for each hand.
  void update(const std::optional<ToolPose>* poses, double elapsed) noexcept;
  /// The force on a hand in that tick; its pose must be that of the tick.
  SceneForce force(
    std::size_t hand, const ToolPose& pose, const StiffnessLimits& limits) const noexcept;

  /// One tick of one hand.
  SceneForce update(const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept
  {
    const std::optional<ToolPose> poses(pose);
    this->update(&poses, elapsed);
    return this->force(0, pose, limits);
  }
  /// Makes one tick of one hand, for a tool along the body's normal.
  SceneForce update(const Vector3& tip, double elapsed, double stiffnessLimit) noexcept
  {
    StiffnessLimits limits;
    limits.straight = stiffnessLimit;
    return this->update(ToolPose(tip), elapsed, limits);
  }

  /// Makes the tick of update() on copies of the contacts. During a ramp the old scene is also
  /// computed, and its result is discarded. Changes no result of update() and force().
  void rehearse(const std::optional<ToolPose>* poses, double elapsed) const noexcept;
  /// The force of the current scene on a hand in the rehearsed tick.
  SceneForce rehearsedForce(
    std::size_t hand, const ToolPose& pose, const StiffnessLimits& limits) const noexcept;

  /// See ToolContact::foresee.
  void foresee() const noexcept
  {
    this->Current->contacts.foresee();
    if (this->Leaving)
    {
      this->Leaving->contacts.foresee();
    }
  }

  /// Begins the change to this scene. Returns false for null, or if the scene is made for another
  /// number of hands; such a scene is only returned by takeRetired().
  bool change(std::unique_ptr<ServoScene> next) noexcept;
  bool isSwitching() const noexcept { return this->Leaving != nullptr; }
  /// Number of changes, including a change that has only begun.
  std::uint32_t changes() const noexcept { return this->Changes; }
  /// Whether the contacts of several hands act on one another, in one of the scenes.
  bool isCoupled() const noexcept
  {
    return this->Current->body->coupling || (this->Leaving && this->Leaving->body->coupling);
  }
  /// The scenes that are no longer needed, as a list, or null; they must be freed outside the tick.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return std::move(this->Retired); }

  /// Ends the contacts and a ramp: only the newest scene remains. The memory of the body is kept.
  void forget() noexcept;
  /// Ends the contacts of one hand, which then no longer act on the others. A ramp continues.
  void forget(std::size_t hand) noexcept;
  /// As forget(), and clears the memory of the body.
  void reset() noexcept;

private:
  void begin(std::unique_ptr<ServoScene> next) noexcept;
  /// Ends a ramp; the change to a waiting scene begins.
  void end() noexcept;
  void retire(std::unique_ptr<ServoScene> scene) noexcept;
  /// Begins the contacts of the new scene at the places of the old contacts.
  void enter(const std::optional<ToolPose>* poses) noexcept;
  void blend(const SceneForce& before, SceneForce& felt) const noexcept;

  std::unique_ptr<ServoScene> Current;
  std::unique_ptr<ServoScene> Leaving; ///< null except during a ramp
  std::unique_ptr<ServoScene> Waiting; ///< null except after a change during a ramp
  std::unique_ptr<ServoScene> Retired;
  ForceRamp Ramp{ 0.0 };
  bool Moves = false; ///< the ramp advanced in the last tick
  /// Hands that had no tick in this ramp yet; all hands: the ramp has not begun.
  std::bitset<ServoScene::MostHands> Entering;
  std::uint32_t Changes = 0;
};
} // namespace palpate

#endif
