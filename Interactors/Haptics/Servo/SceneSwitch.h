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
 * A body with the response of a tool, which one ServoStep renders. Another body, tool or material,
 * or other settings, need another scene. Scenes are made and freed outside the servo tick; the tick
 * only exchanges them.
 */
struct ServoScene
{
  static constexpr std::size_t MostHands = 4;

  /// `contactBody` must not be null; the scene shares the ownership of the body.
  /// `sceneForceFactor`, in (0, 1], fits this scene to the device; the force is multiplied by it
  /// and by SafetySettings::forceFactor. A factor out of this range counts as 0, and the force is
  /// then zero. `hands` is the number of devices, each with one contact; it is clamped to the range
  /// 1 to MostHands.
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
    // The loop frees the scenes of the list one by one, because a recursion would be as deep as the
    // list is long.
    while (this->next)
    {
      this->next = std::move(this->next->next);
    }
  }
  /// Copies the scene and the history of its contacts, but not the list of scenes.
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
  CoupledContacts rehearsed; ///< copy of `contacts` after a tick that was computed in advance
  const double forceFactor;
  /// The next scene in a list of scenes that are no longer needed. Freeing the first scene of the
  /// list frees all scenes.
  std::unique_ptr<ServoScene> next;
};

/// The largest stiffnesses, in the body frame, that a scene with the force factor 1 may have.
struct StiffnessLimits
{
  double straight = std::numeric_limits<double>::infinity(); ///< for translation, N/mm
  double turning = std::numeric_limits<double>::infinity();  ///< for rotation, N mm/rad
};

/// The fraction (0 to 1) of a contact's torque that remains if the torsional stiffness of the
/// contact is limited to `limit`, N mm/rad. The torsional stiffness is estimated as |M|/θ with the
/// torque M and the tilt θ, because no better value is known. The estimate is exact for a flat end
/// in full contact.
inline double cappedTorqueShare(const Contact& contact, double limit) noexcept
{
  const double torque = contact.torque.norm();
  const double most = limit * contact.tilt; // NaN if the limit is infinite and the tilt is zero
  return most < torque ? most / torque : 1.0;
}

/// The force of a scene on one tip, or the blend of two scenes during a change. Body frame; mm, N.
struct SceneForce
{
  Contact contact;                      ///< contact of the newest scene
  Vector3 idealForce = Vector3::Zero(); ///< force, blended during a change; contact.force otherwise
  Vector3 cappedForce = Vector3::Zero(); ///< force with the stiffness of each scene capped, blended
  Vector3 idealTorque = Vector3::Zero(); ///< torque about the tip, N mm, blended
  /// Torque with the torsional stiffness of each scene capped, blended.
  Vector3 cappedTorque = Vector3::Zero();
  double forceFactor = 1.0; ///< force factor, blended; if 0, no force is sent
  double share = 1.0;       ///< fraction of idealForce from the newest scene
  /// The longest displacement (mm) over which the contact can return work: the deflection, the
  /// lowering of the surface by the other hands, and the elastic displacement of the friction.
  double reach = 0.0;
  bool outside = true;   ///< whether the tip has no contact
  bool changing = false; ///< whether `share` differs from its value in the last tick
};

/**
 * The scene of a ServoStep, and the change to another scene while tips may be in contact.
 *
 * The force on each hand changes from the old scene to the new one within 50 ms (ForceRamp). The
 * contacts of both scenes are computed at the present tips. The sent force is (1-w) φ F of the old
 * scene plus w φ' F' of the new one, where w grows linearly in time and φ, φ' are the force
 * factors. Therefore the force changes per tick by at most |φ'F' - φF| T / 50 ms, in addition to
 * the blended changes of both forces by motion. No tick is stiffer than the stiffer of the two
 * scenes.
 *
 * The new contact begins at the position of the old one. On a thin body it begins on the same face
 * as the old contact, if both bodies have this face. The new contact takes over the pre-sliding
 * displacement of the old one (Friction::assume), within the friction limit of the new contact. A
 * scene that is passed during a ramp waits for the end of the ramp. Without waiting, a third
 * contact would be necessary, or a force that does not respond to the hand. If several scenes wait,
 * only the newest is used.
 *
 * The contacts of a hand without a pose are kept in both scenes, and their time advances. While no
 * hand has a pose, the ramp does not advance.
 *
 * Only the constructors allocate or free memory; a tick of a ramp costs two contacts per hand.
 */
class PALPATE_EXPORT SceneSwitch
{
public:
  /// `scene` must not be null.
  explicit SceneSwitch(std::unique_ptr<ServoScene> scene) noexcept;
  /// Copies the switch with its scenes, except the scenes that are no longer needed.
  SceneSwitch(const SceneSwitch& other);
  SceneSwitch(SceneSwitch&& other) noexcept = default;
  SceneSwitch& operator=(const SceneSwitch&) = delete;
  SceneSwitch& operator=(SceneSwitch&&) = delete;
  ~SceneSwitch() = default;

  /// Number of hands, which is the same for all scenes.
  std::size_t hands() const noexcept { return this->Current->contacts.count(); }

  /// Computes one tick with one pose for each hand. `elapsed` is the time since the last tick, s.
  void update(const std::optional<ToolPose>* poses, double elapsed) noexcept;
  /// The force on a hand in the last tick. `pose` must be the pose that was passed for this tick.
  SceneForce force(
    std::size_t hand, const ToolPose& pose, const StiffnessLimits& limits) const noexcept;

  /// Computes one tick of a single hand and returns its force.
  SceneForce update(const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept
  {
    const std::optional<ToolPose> poses(pose);
    this->update(&poses, elapsed);
    return this->force(0, pose, limits);
  }
  /// Computes one tick of a single hand whose tool is along the body's normal.
  SceneForce update(const Vector3& tip, double elapsed, double stiffnessLimit) noexcept
  {
    StiffnessLimits limits;
    limits.straight = stiffnessLimit;
    return this->update(ToolPose(tip), elapsed, limits);
  }

  /// Computes the tick of update() on copies of the contacts. During a ramp the old scene is also
  /// computed, and its result is discarded. The results of update() and force() do not change.
  void rehearse(const std::optional<ToolPose>* poses, double elapsed) const noexcept;
  /// The force of the current scene on a hand in the rehearsed tick.
  SceneForce rehearsedForce(
    std::size_t hand, const ToolPose& pose, const StiffnessLimits& limits) const noexcept;

  /// Prefetches the memory for the next tick; see ToolContact::foresee.
  void foresee() const noexcept
  {
    this->Current->contacts.foresee();
    if (this->Leaving)
    {
      this->Leaving->contacts.foresee();
    }
  }

  /// Begins the change to another scene. Returns false if the scene is null or is made for another
  /// number of hands. A scene for another number of hands is only handed back by takeRetired().
  bool change(std::unique_ptr<ServoScene> next) noexcept;
  bool isSwitching() const noexcept { return this->Leaving != nullptr; }
  /// Number of changes, including a change that is not yet complete.
  std::uint32_t changes() const noexcept { return this->Changes; }
  /// Whether the contacts of several hands affect one another in one of the scenes.
  bool isCoupled() const noexcept
  {
    return this->Current->body->coupling || (this->Leaving && this->Leaving->body->coupling);
  }
  /// Returns the scenes that are no longer needed, as a list, or null. The caller must free them
  /// outside the servo tick.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return std::move(this->Retired); }

  /// Ends the contacts and a ramp, so that only the newest scene remains. The memory (relaxation
  /// state) of the body is kept.
  void forget() noexcept;
  /// Ends the contacts of one hand, which then no longer affect the other hands. A ramp continues.
  void forget(std::size_t hand) noexcept;
  /// Does the same as forget(), and also clears the memory (relaxation state) of the body.
  void reset() noexcept;

private:
  void begin(std::unique_ptr<ServoScene> next) noexcept;
  /// Ends a ramp. If a scene waits, the change to it begins.
  void end() noexcept;
  void retire(std::unique_ptr<ServoScene> scene) noexcept;
  /// Begins the contacts of the new scene at the positions of the old contacts.
  void enter(const std::optional<ToolPose>* poses) noexcept;
  void blend(const SceneForce& before, SceneForce& felt) const noexcept;

  std::unique_ptr<ServoScene> Current;
  std::unique_ptr<ServoScene> Leaving; ///< the old scene during a ramp, otherwise null
  std::unique_ptr<ServoScene> Waiting; ///< a scene that was passed during a ramp, otherwise null
  std::unique_ptr<ServoScene> Retired;
  ForceRamp Ramp{ 0.0 };
  bool Moves = false; ///< whether the ramp advanced in the last tick
  /// Hands that had no tick in this ramp yet. If all bits are set, the ramp has not begun.
  std::bitset<ServoScene::MostHands> Entering;
  std::uint32_t Changes = 0;
};
} // namespace palpate

#endif
