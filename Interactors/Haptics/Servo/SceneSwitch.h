// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_SceneSwitch_h
#define palpate_SceneSwitch_h

#include "Haptics/Safety/SafetyLinks.h"
#include "Mechanics/PalpateExport.h"
#include "Contact/Coupled/CoupledContacts.h"
#include "Contact/ToolContact.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace palpate
{
/**
 * A body with the response of a tool, as one ServoStep renders it: another body, tool, material or
 * other settings are another scene. Made and freed outside of the tick, which only hands it on.
 */
struct ServoScene
{
  /// `contactBody` must not be null and is kept alive by the scene. `sceneForceFactor` (0, 1] fits
  /// this scene to the device, beside SafetySettings::forceFactor: their product is what counts.
  /// Outside of its range it gives no force. For a HandsStep each of its hands has a contact; 0:
  /// for a ServoStep.
  explicit ServoScene(std::shared_ptr<const ContactBody> contactBody,
    const ContactSettings& contactSettings = {}, double sceneForceFactor = 1.0,
    std::size_t hands = 0)
    : body(std::move(contactBody))
    , settings(contactSettings)
    , contact(*this->body, contactSettings)
    , together(hands > 0 ? std::make_unique<CoupledContacts>(*this->body, contactSettings, hands)
                         : nullptr)
    , forceFactor(sceneForceFactor > 0.0 && sceneForceFactor <= 1.0 ? sceneForceFactor : 0.0)
  {
  }
  ~ServoScene()
  {
    // One after the other: a long list would nest as deep.
    while (this->next)
    {
      this->next = std::move(this->next->next);
    }
  }
  /// A copy with its history, without the list.
  ServoScene(const ServoScene& other)
    : body(other.body)
    , settings(other.settings)
    , contact(other.contact)
    , together(other.together ? std::make_unique<CoupledContacts>(*other.together) : nullptr)
    , forceFactor(other.forceFactor)
  {
  }
  ServoScene& operator=(const ServoScene&) = delete;

  const std::shared_ptr<const ContactBody> body;
  const ContactSettings settings;
  ToolContact contact;
  const std::unique_ptr<CoupledContacts> together; ///< of several hands, instead; or null
  const double forceFactor;
  /// Scenes no longer needed are a list: freeing the first frees all.
  std::unique_ptr<ServoScene> next;
};

/// Up to which stiffness a scene may be felt at a force factor of 1; the body's frame.
struct StiffnessLimits
{
  double straight = std::numeric_limits<double>::infinity(); ///< N/mm
  double turning = std::numeric_limits<double>::infinity();  ///< N mm/rad
};

/// Of the torque of a contact so much may stay where the torsional stiffness that a loop feels is
/// to be no larger than `limit`, N mm/rad: 0 to 1. Of that stiffness no more is known than |M|/θ,
/// which it is of a flat end in full contact.
inline double cappedTorqueShare(const Contact& contact, double limit) noexcept
{
  const double torque = contact.torque.norm();
  const double most = limit * contact.tilt; // NaN where nothing is limited and nothing is tilted
  return most < torque ? most / torque : 1.0;
}

/// What the tip feels of a scene, or of two of which one is left for the other. Body frame; mm, N.
struct SceneForce
{
  Contact contact;                        ///< of the newest scene
  Vector3 idealForce = Vector3::Zero();   ///< blended; contact.force when not switching
  Vector3 cappedForce = Vector3::Zero();  ///< the same, each stiffness capped
  Vector3 idealTorque = Vector3::Zero();  ///< about the tip, N mm, likewise
  Vector3 cappedTorque = Vector3::Zero(); ///< the same, each torsional stiffness capped
  double forceFactor = 1.0;               ///< blended; 0: there is no force
  double share = 1.0;                     ///< of idealForce: of the newest scene
  /// Over no longer way (mm) can the contacts give back work: out of the body, and as far as
  /// friction is stretched.
  double reach = 0.0;
  bool outside = true;   ///< no contact
  bool changing = false; ///< the share is another than in the tick before
};

/// What a contact of a scene is to a tool in that pose, where of its force `share` may stay under
/// the stiffness cap.
PALPATE_EXPORT SceneForce forceOf(const ServoScene& scene, const Contact& contact, double share,
  const ToolPose& pose, const StiffnessLimits& limits) noexcept;

/**
 * The scene of a ServoStep, and how it is left for another while the tip may be in contact.
 *
 * Within 50 ms the force goes over from one to the other (ForceRamp), both being felt at the tip of
 * now: what is sent is (1-w) φ F of the old and w φ' F' of the new, straight in time with the force
 * factors φ included, so that it changes per tick by no more than motion changes the two, blended,
 * and |φ'F' - φF| T / 50 ms. No tick is stiffer than the stiffer of the two.
 *
 * The new contact begins where the old one is: under the same side of a thin body, if both have it
 * there. It begins without pre-sliding displacement, so friction builds up anew; the old one keeps
 * its own until it is gone. A scene that comes during a ramp waits for its end (it would take a
 * third contact, or a force that no longer answers to the hand); of several that wait the newest is
 * taken.
 *
 * Nothing here allocates or frees but the constructors; a tick of a ramp costs two contacts.
 */
class PALPATE_EXPORT SceneSwitch
{
public:
  /// `scene` is not null.
  explicit SceneSwitch(std::unique_ptr<ServoScene> scene) noexcept;
  /// With copies of the scenes, but none that is no longer needed.
  SceneSwitch(const SceneSwitch& other);
  SceneSwitch(SceneSwitch&& other) noexcept = default;
  SceneSwitch& operator=(const SceneSwitch&) = delete;
  SceneSwitch& operator=(SceneSwitch&&) = delete;
  ~SceneSwitch() = default;

  /// One tick, `elapsed` (s) after the last.
  SceneForce update(const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept;

  /// The same for a tool along the body's normal.
  SceneForce update(const Vector3& tip, double elapsed, double stiffnessLimit) noexcept
  {
    StiffnessLimits limits;
    limits.straight = stiffnessLimit;
    return this->update(ToolPose(tip), elapsed, limits);
  }

  /// As ToolContact::foresee.
  void foresee() const noexcept
  {
    this->Current->contact.foresee();
    if (this->Leaving)
    {
      this->Leaving->contact.foresee();
    }
  }

  /// What an update would feel of the current scene, on a copy of its contact that is thrown away;
  /// a scene that is left is felt likewise, and forgotten. Changes nothing.
  SceneForce rehearse(
    const ToolPose& pose, double elapsed, const StiffnessLimits& limits) const noexcept;

  /// Begins to leave the scene for this one; null changes nothing.
  void change(std::unique_ptr<ServoScene> next) noexcept;
  bool isSwitching() const noexcept { return this->Leaving != nullptr; }
  /// How many scenes were left, or begun to be.
  std::uint32_t changes() const noexcept { return this->Changes; }
  /// What is no longer needed, as a list, or null; to be freed outside of the tick.
  std::unique_ptr<ServoScene> takeRetired() noexcept { return std::move(this->Retired); }

  /// The contacts are over, and so is a ramp: the newest scene is the only one. What its body
  /// remembers of having been pressed stays.
  void forget() noexcept;
  /// The same, and what the body remembers is forgotten too.
  void reset() noexcept;
  /// Lets time pass (s) while the position of the tip is not known.
  void pass(double elapsed) noexcept;

private:
  void begin(std::unique_ptr<ServoScene> next) noexcept;
  /// Ends a ramp; one that waits begins.
  void end() noexcept;
  void retire(std::unique_ptr<ServoScene> scene) noexcept;
  SceneForce blend(const ToolPose& pose, double elapsed, const StiffnessLimits& limits) noexcept;

  std::unique_ptr<ServoScene> Current;
  std::unique_ptr<ServoScene> Leaving; ///< null but during a ramp
  std::unique_ptr<ServoScene> Waiting; ///< null but after a change during a ramp
  std::unique_ptr<ServoScene> Retired;
  ForceRamp Ramp{ 0.0 };
  bool Entering = false; ///< the ramp has had no tick yet
  std::uint32_t Changes = 0;
};
} // namespace palpate

#endif
